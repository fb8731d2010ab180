// The types for the scripts in book/theme: what the scripts share, and what the modules reply. The
// command `npm run types` checks the scripts against these types.

/** What the pages' scripts share: the members of the global object `book`. */
interface Book {
  /** The `html` element. */
  root: HTMLElement;

  // book.js

  /** Makes an element with these attributes and children. */
  make<K extends keyof HTMLElementTagNameMap>(
    tag: K, attributes: Record<string, string | number | boolean>, ...children: (Node | string)[]
  ): HTMLElementTagNameMap[K];
  /**
   * Sets an element's text, unless the element already has this text. Setting the same text again
   * would make the browser lay out the element again.
   */
  setText(element: Element, text: string): void;
  /** Makes a range of `length` letters in an element, starting with the letter at `from`. */
  makeRange(element: Element, from: number, length: number): Range;
  /** Runs a function that writes HTML. The HTML has to come from these scripts or the modules. */
  writeHTML(act: () => void): void;
  /** Allows the page to load a script, or start a worker, from this address. */
  trustAddress(address: string): void;
  /**
   * Copies a text to the clipboard, if the browser allows that. For a while, the button says
   * whether the text was copied.
   */
  copyAndReport(button: HTMLButtonElement, text: string, words?: string): Promise<void>;
  /** Returns the keys and values that the browser stores under this name, or an empty object. */
  recall(name: string): Record<string, any>;
  /** Stores a value in the browser under a name and a key, if the reader's settings allow that. */
  store(name: string, key: string, value: string | boolean): void;
  /** In the contents, ticks the steps for which the reader's picture was right. */
  markRight(): void;
  /**
   * Parses a number as people type it, such as `58.72`, `58,72`, `1/2`, `−3` or `60°`. Returns NaN
   * if the text isn't a number.
   */
  readNumber(text: string): number;
  /**
   * Returns by how many states a key moves in the history: −1 for Ctrl+Z, 1 for Ctrl+Shift+Z or
   * Ctrl+Y, and 0 for any other key.
   */
  readUndoKey(event: KeyboardEvent): number;
  /** Calls `near` once for each element, when that element comes near the view. */
  whenNear(elements: Iterable<HTMLElement> & { forEach(act: (element: HTMLElement) => void): void }, near: (element: HTMLElement) => void): void;
  /**
   * Loads a script, unless it has been loaded already. Returns whether the script is loaded.
   * Scripts run in the order of the calls, except for large scripts. If a script can't be loaded,
   * the next call tries again.
   */
  load(file: string, isLarge?: boolean): Promise<boolean>;
  /** Colours a listing. */
  colourCode(code: Element): void;
  /**
   * Colours a listing once the script for colouring has loaded, unless the listing is being edited.
   */
  colour(code: Element): void;
  /** For each preview that was pressed before the preview was ready: the last press. */
  presses: Map<Element, PointerEvent>;
  /** A history of states, for undo and redo. */
  History: new <State>(state: State) => UndoHistory<State>;

  // wasm.js

  modules: {
    /** Stores a file, encoded as base64. A generated script that contains a file calls this. */
    provide(name: string, base64: string): void;
    /** Loads a module and the files that the module needs, without starting the module. */
    compile(name: ModuleName): Promise<CompiledModule>;
    /** Returns the module of this name. Starts the module if it isn't running. */
    get(name: ModuleName): Promise<Module>;
    /** Forgets a module that failed, so that the next request starts it again. */
    drop(name: ModuleName): void;
  };
  /** Starts a module. If the module needs the list of mistakes, passes the list to the module. */
  startModule(compiled: CompiledModule): Promise<Module>;
  /** The error for a request that a module refuses. */
  Refusal: new (message: string) => Error;
  /**
   * Sends a request to a module, with a file if the request needs one, and returns the module's
   * reply. Throws a `Refusal` if the reply is an error.
   */
  ask<R extends ModuleRequest>(module: Module, request: R, file?: Uint8Array): ModuleReplies[R["request"]];
  /**
   * Paints the pixels of a reply on a canvas. Paints all columns, or only `columns` columns,
   * starting at `column`.
   */
  paint(canvas: HTMLCanvasElement, reply: Pixels, column?: number, columns?: number): void;

  // handle.js, own_scene.js, figure.js

  /** A mark in a figure that the reader can drag. */
  Handle: new (figure: InteractiveFigure, about: HandleAbout, index: number) => Handle;
  /** Adds the tools of an editable scene to its figure. */
  followScene(figure: InteractiveFigure): void;
  /** Makes a figure interactive. */
  activateFigure(root: HTMLElement): Promise<void>;

  // search-index.js

  /**
   * For each page: its name, its title and its sections. For each section: its id, title, prose and
   * listings, and the phrases by which readers look for the section.
   */
  searchIndex: [string, string, [string, string, string, string, string[]][]][];
  /**
   * For each hint: the section to read, the compiler's messages that lead to the hint, and what to
   * do.
   */
  searchHints: [string, string[], string][];
  /** Groups of words with nearly the same meaning. */
  searchSynonyms: string[][];
}

interface UndoHistory<State> {
  /**
   * Adds a state, and drops the states that were undone. Does nothing if the state equals the
   * current state.
   */
  record(state: State): void;
  /**
   * Whether the history has a state this many steps after the current state, or before the current
   * state if `steps` is negative.
   */
  has(steps: number): boolean;
  /** Moves by this many steps, and returns the new current state. */
  go(steps: number): State;
}

// The modules.

type ModuleName = "live" | "check" | "expressions";

interface CompiledModule {
  module: WebAssembly.Module;
  mistakes?: Uint8Array;
}

interface Module {
  memory: WebAssembly.Memory;
  allocate_input(index: number, length: number): number;
  make_reply(): number;
}

interface Pixels {
  size?: [number, number];
  pixels?: Uint8ClampedArray<ArrayBuffer>;
}

/**
 * A request from a script to a module. The script sends it as JSON. The crate `page` parses it in
 * request.rs, where the fields have the same names.
 */
type ModuleRequest = MistakesRequest | CheckRequest | CheckSceneRequest | EditRequest | FigureRequest;

/** Makes the module store the list of mistakes. The list is the file sent with the request. */
interface MistakesRequest {
  request: "mistakes";
}

/** Checks the picture in the file sent with the request. */
interface CheckRequest {
  request: "check";
  fileName: string;
  /**
   * The name of the expected picture, or null if `check` has to find out which picture is in the
   * file.
   */
  picture: string | null;
}

/**
 * Checks whether the file is the picture of the scene that is generated from this person's name.
 */
interface CheckSceneRequest {
  request: "check-scene";
  fileName: string;
  person: string;
}

/** Draws the picture of a step in which these edited lines replace the book's lines. */
interface EditRequest {
  request: "edit";
  columns: number;
  /** The edited lines. The first is the line that the reader is editing now. */
  lines: { place: string, text: string }[];
}

/** Asks for something about the figure of this name. */
type FigureRequest = { figure: string } & (
  /** Asks for a description of the parameters and the handles. */
  | { request: "about" }
  /** Asks for everything that the page shows at these values of the parameters. */
  | { request: "show", values: ParameterValues, columns: number | null }
  /** Asks for the same as "show", but without the drawing or the pixels. */
  | { request: "read", values: ParameterValues }
  /** Asks for the same as "show", after a handle was dragged. */
  | { request: "drag", values: ParameterValues, handle: number, position: [number, number], columns: number | null }
  /** Asks for the object at a position. */
  | { request: "pick", values: ParameterValues, position: [number, number] }
  /** Asks for the same as "show", at the values in an address. */
  | { request: "open", address: string }
);

/** The part of a request that depends on what the reader does. The figure adds the rest. */
type Gesture =
  | { request: "show" }
  | { request: "read" }
  | { request: "drag", handle: number, position: [number, number] };

/** For each kind of request: the reply, unless the module refuses the request. */
interface ModuleReplies {
  mistakes: {};
  check: CheckReply;
  "check-scene": CheckReply;
  edit: EditReply;
  about: FigureAbout;
  show: FigureReply;
  read: FigureReply;
  drag: FigureReply;
  pick: { object: string | null };
  open: FigureReply;
}

/**
 * The exit code of `check`: 0 if the picture is right, 1 if the picture is wrong, and 2 if the
 * picture can't be checked.
 */
type ExitCode = 0 | 1 | 2;

/**
 * The reply of `check` to a file. `lines` is the text of the answer, headline first. If a line
 * names a section of the book, `links` contains the section's address, keyed by the line.
 */
interface CheckReply extends Pixels {
  code: ExitCode;
  lines: string[];
  links?: Record<string, string>;
}

/**
 * The reply to edited lines: a picture and a note about the picture, or what is wrong with one of
 * the lines.
 */
interface EditReply extends Pixels {
  note?: string;
  names?: string[];
  line?: string;
  from?: number;
  to?: number;
  fault?: string;
}

// Figures, as the crate `figures` describes them.

/** The value of each parameter, keyed by the parameter's id. */
type ParameterValues = Record<string, number>;

interface ParameterAbout {
  id: string;
  object: string | null;
  name: string;
  default: number;
  min: number;
  max: number;
  step: number;
  axis: "right" | "up" | "down" | null;
}

interface HandleAbout {
  label: string;
  mark: "point" | "light" | "probe";
  /** The ids of the parameters that the handle sets. */
  horizontal: string;
  vertical: string;
  depth: string | null;
  /** The id of the switch that adds the handle's object to the scene. */
  presence: string | null;
}

interface FigureAbout {
  parameters: ParameterAbout[];
  handles: HandleAbout[];
  /** How many columns the figure's picture has at full size. Null if the figure is a drawing. */
  columns: number | null;
  /**
   * In an editable scene: for each object, the ids of the parameters for red, green and blue.
   */
  colours?: Record<string, string[]>;
}

interface FigureReply extends Pixels {
  values: ParameterValues;
  texts: Record<string, string>;
  visible: Record<string, boolean>;
  positions: ([number, number] | null)[];
  readouts: Record<string, string>;
  drawing?: string;
  /** Only an editable scene has a program and an address. */
  program?: string;
  address?: string;
}

interface Control {
  element: HTMLElement;
  inputs: HTMLInputElement[];
  output: HTMLElement | null;
  object: string | undefined;
}

interface Handle {
  about: HandleAbout;
  element: HTMLElement;
  /** The handle's index in the figure's list of handles. */
  index: number;
  /** In an editable scene: the object that the handle moves. */
  object: string | undefined;
  /** The handle's position in the last reply. */
  position: [number, number] | null;
  grab(event: PointerEvent): void;
  changeDepth(length: number): void;
  show(): void;
}

interface InteractiveFigure {
  name: string;
  module: Module;
  about: FigureAbout;
  parameters: Map<string, ParameterAbout>;
  values: ParameterValues;
  reply: FigureReply;
  handles: Handle[];
  probe: Handle | undefined;
  root: HTMLElement;
  /** Whether the figure is a preview, which has no controls. */
  isPreview: boolean;
  stage: HTMLElement;
  controls: HTMLElement;
  fault: HTMLElement;
  output: HTMLElement;
  reset: HTMLButtonElement;
  /** In an editable scene: the menu in which the reader chooses an object. */
  objectSelect: HTMLSelectElement | null;
  /** Width and height, in the figure's own coordinates. */
  size: number[];
  /** Registers a callback to be called each time after a reply is shown. */
  afterShow(callback: () => void): void;
  /** Registers a callback to be called each time after the controls are shown. */
  afterControls(callback: () => void): void;
  setValue(id: string, value: number): void;
  /** Whether the figure has something to show if the parameter `id` has this value. */
  canShow(id: string, value: number): boolean;
  controlOf(id: string): Control;
  selectObject(object: string | undefined): void;
  draw(): void;
  drawMoving(gesture: Gesture): void;
  drawNextFrame(gesture: Gesture): void;
  show(reply: FigureReply): void;
  positionOfPointer(pointer: { clientX: number, clientY: number }): [number, number];
}

/** An editable line in a listing. */
interface EditedLine extends HTMLElement {
  /** The HTML of the book's code for this line, including the colours. */
  bookHTML?: string;
}

// Declarations that TypeScript's own types for browsers don't contain.

interface ParentNode {
  querySelector<K extends keyof HTMLElementTagNameMap>(selectors: K): HTMLElementTagNameMap[K];
  querySelectorAll<K extends keyof HTMLElementTagNameMap>(selectors: K): NodeListOf<HTMLElementTagNameMap[K]>;
  /**
   * Callers know which elements the builder has written. A caller that needs more than an
   * `HTMLElement` names the element's type.
   */
  querySelector<E extends HTMLElement>(selectors: string): E;
  querySelectorAll<E extends HTMLElement>(selectors: string): NodeListOf<E>;
}

interface Window {
  hljs?: { highlightBlock(code: Element): void };
  MiniSearch?: unknown;
  trustedTypes?: { createPolicy(name: string, rules: Record<string, (text: string) => string | null>): void };
}

/** The library for the search. */
declare const MiniSearch: new (options: object) => any;
