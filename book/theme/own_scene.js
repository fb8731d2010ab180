"use strict";

// A scene of the reader's own is in the address of the page, once a gesture has come to rest.
function followScene(figure) {
    let sceneAddress = figure.answer.numbers.address;
    let addressTimer = 0;
    const writeAddress = address => history.replaceState(null, "", address ? `#scene=${address}` : location.pathname + location.search);
    figure.afterShow = () => {
        const { address } = figure.answer.numbers;
        if (address === sceneAddress) return;
        sceneAddress = address;
        clearTimeout(addressTimer);
        addressTimer = setTimeout(writeAddress, 200, address);
    };
    const openScene = () => {
        if (!location.hash.startsWith("#scene=")) {
            // A heading was pressed: the page has gone there, and the address is the scene's again.
            if (sceneAddress) writeAddress(sceneAddress);
            return;
        }
        // Some mail programs write a colon as %3A.
        const address = location.hash.slice("#scene=".length).replace(/%3A/gi, ":").replace(/%2C/gi, ",");
        try {
            const answer = figure.ask("open", address);
            sceneAddress = answer.numbers.address;
            figure.show(answer);
        } catch ({ message }) {
            figure.fault.textContent = `${message} Nothing has changed.`;
        }
    };
    addEventListener("hashchange", openScene);
    openScene();
}
