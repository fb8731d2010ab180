use course::workspace;
use figures::Reply;
use std::fs;
use wasmi::{
    CompilationMode, Config, Engine, Instance, Linker, Memory, Store, WasmParams, WasmResults,
};

/// The bytes of the module `name`, as it is checked in.
pub fn read_module(name: &str) -> Vec<u8> {
    let path = workspace().join(format!("book/crates/page/{name}.wasm"));
    fs::read(path).expect("the module can be read")
}

/// A module, running as in a page.
pub struct Module {
    store: Store<()>,
    instance: Instance,
    memory: Memory,
}

impl Module {
    /// Starts the module `name`, which imports nothing.
    pub fn start_checked_in(name: &str) -> Self {
        let mut config = Config::default();
        // Most functions are called by few tests.
        config.compilation_mode(CompilationMode::Lazy);
        let engine = Engine::new(&config);
        let module = wasmi::Module::new(&engine, read_module(name)).expect("a module");
        let mut store = Store::new(&engine, ());
        let instance = Linker::new(&engine).instantiate_and_start(&mut store, &module);
        let instance = instance.expect("it starts");
        let memory = instance.get_memory(&store, "memory").expect("it has memory");
        Self { store, instance, memory }
    }

    /// Asks it as book/theme/live.js does, by a request about a file; none where
    /// it fails.
    pub fn answer(&mut self, request: &str, file: &[u8]) -> Option<Reply> {
        for (room, bytes) in [("live_request", request.as_bytes()), ("live_file", file)] {
            let address: u32 = self.call(room, bytes.len() as u32)?;
            self.memory.write(&mut self.store, address as usize, bytes).ok()?;
        }
        self.call::<_, ()>("live_answer", ())?;
        let text = self.read_memory("live_text", "live_text_length")?;
        let pixels = self.read_memory("live_pixels", "live_pixels_length")?;
        Some(Reply { text: String::from_utf8(text).ok()?, pixels })
    }

    fn read_memory(&mut self, address_export: &str, length_export: &str) -> Option<Vec<u8>> {
        let address_export: u32 = self.call(address_export, ())?;
        let length_export: u32 = self.call(length_export, ())?;
        let memory = self.memory.data(&self.store);
        Some(memory.get(address_export as usize..)?.get(..length_export as usize)?.to_vec())
    }

    fn call<P: WasmParams, R: WasmResults>(&mut self, name: &str, parameters: P) -> Option<R> {
        let function = self.instance.get_typed_func(&self.store, name).ok()?;
        function.call(&mut self.store, parameters).ok()
    }
}
