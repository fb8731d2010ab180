// The types for the scripts in book/theme: what the scripts share, and what the modules reply. The
// command `npm run types` checks the scripts against them.

/** What the pages' scripts share, under the only name that they have in common. */
interface Book {
  /** The `html` element. */
  root: HTMLElement;

  // book.js

  /** Makes an element with these attributes and children. */
  make<K extends keyof HTMLElementTagNameMap>(
    tag: K, attributes: Record<string, string | number | boolean>, ...children: (Node | string)[]
  ): HTMLElementTagNameMap[K];
  /**
   * Sets an element's text, unless the text is there already. In that case, nothing has to be laid
   * out again.
   */
  setText(element: Element, text: string): void;
  /** Makes a range of `length` letters in an element, starting with the one at `from`. */
  makeRange(element: Element, from: number, length: number): Range;
  /** Runs a function that writes HTML, which has to come from these scripts or the modules. */
  writeHTML(act: () => void): void;
  /** Allows the page to load a script, or start a worker, from this address. */
  trustAddress(address: string): void;
  /**
   * Copies a text, if the browser allows it, and says on the button for a while whether it was
   * copied.
   */
  copyAndReport(button: HTMLButtonElement, text: string, words?: string): Promise<void>;
  /** Returns the values that the browser stores under this name, by key, or an empty object. */
  recall(name: string): Record<string, any>;
  /** Stores a value in the browser under a name and a key, if the reader's settings allow that. */
  store(name: string, key: string, value: string | boolean): void;
  /** Ticks the steps in the contents for which the reader's picture was right. */
  markRight(): void;
  /**
   * Parses a number as people type it: 58.72, 58,72, 1/2, −3 or 60°. Returns NaN if it isn't one.
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
   * Loads a script, unless it has been loaded, and returns whether that worked. Scripts run in the
   * order in which they are asked for, except for large ones. One that failed is loaded again the
   * next time.
   */
  load(file: string, isLarge?: boolean): Promise<boolean>;
  /** Colours a listing. */
  colourCode(code: Element): void;
  /** Colours a listing once the script for that has loaded, unless the listing is being edited. */
  colour(code: Element): void;
  /** The last press on each preview that wasn't ready then. */
  presses: Map<Element, PointerEvent>;
  /** A history of states, for undo and redo. */
  History: new <State>(state: State) => UndoHistory<State>;

  // wasm.js

  modules: {
    /** Stores a file that a generated script contains, encoded as base64. */
    provide(name: string, base64: string): void;
    /** Loads a module and what it needs, without starting it. */
    compile(name: ModuleName): Promise<CompiledModule>;
    /** Returns the module of this name, started. */
    get(name: ModuleName): Promise<Module>;
    /** Forgets a module that failed, so that the next request starts it again. */
    drop(name: ModuleName): void;
  };
  /** Starts a module, and passes it the list of mistakes if it needs that list. */
  startModule(compiled: CompiledModule): Promise<Module>;
  /** The error for a request that a module refuses. */
  Refusal: new (message: string) => Error;
  /**
   * Sends a request to a module, with a file if it needs one, and returns the module's reply.
   * Throws a refusal if the reply is an error.
   */
  ask<R extends ModuleRequest>(module: Module, request: R, file?: Uint8Array): ModuleReplies[R["request"]];
  /**
   * Paints the pixels of a reply on a canvas: all of them, or only `columns` columns, starting at
   * `column`.
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
   * listings, and the phrases by which readers look for it.
   */
  searchIndex: [string, string, [string, string, string, string, string[]][]][];
  /** The section to read, the compiler's messages, and a sentence that says what to do. */
  searchHints: [string, string[], string][];
  /** Groups of words that mean nearly the same. */
  searchSynonyms: string[][];
}

interface UndoHistory<State> {
  /** Adds a state, unless it equals the current one, and drops the states that were undone. */
  record(state: State): void;
  /** Whether there is a state this many steps later, or earlier if the number is negative. */
  has(steps: number): boolean;
  /** Moves by this many steps, and returns the state there. */
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
 * What the scripts ask the modules for. They send it as JSON, and the crate `page` parses it in
 * request.rs, where the names are the same.
 */
type ModuleRequest = MistakesRequest | CheckRequest | CheckSceneRequest | EditRequest | FigureRequest;

/** Keeps the list of mistakes, which is the file. */
interface MistakesRequest {
  request: "mistakes";
}

/** Checks the file. */
interface CheckRequest {
  request: "check";
  fileName: string;
  /** The name of the expected picture, or null if `check` should find that out. */
  picture: string | null;
}

/** Checks whether the file is the picture of a person's scene. */
interface CheckSceneRequest {
  request: "check-scene";
  fileName: string;
  person: string;
}

/** Draws a step with edited lines in it. */
interface EditRequest {
  request: "edit";
  columns: number;
  /** The first is the one that the reader is editing now. */
  lines: { place: string, text: string }[];
}

/** Asks for something about the figure of this name. */
type FigureRequest = { figure: string } & (
  /** Describes the parameters and the handles. */
  | { request: "about" }
  /** Sends everything that the page shows at these values. */
  | { request: "show", values: ParameterValues, columns: number | null }
  /** Sends the same without the drawing or the pixels. */
  | { request: "read", values: ParameterValues }
  /** Sends the same as "show", after a handle was dragged. */
  | { request: "drag", values: ParameterValues, handle: number, position: [number, number], columns: number | null }
  /** Finds the object at a position. */
  | { request: "pick", values: ParameterValues, position: [number, number] }
  /** Sends the same as "show", at the values of an address. */
  | { request: "open", address: string }
);

/** The part of a request that depends on what the reader does. The figure adds the rest. */
type Gesture =
  | { request: "show" }
  | { request: "read" }
  | { request: "drag", handle: number, position: [number, number] };

/** The reply to each request, unless it is an error. */
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

/** The exit code of `check`: 0 if the picture is right, 1 if it isn't, and 2 if it can't be checked. */
type ExitCode = 0 | 1 | 2;

/** The reply of `check` to a file, with the lines of its answer, headline first. */
interface CheckReply extends Pixels {
  code: ExitCode;
  lines: string[];
}

/**
 * The reply to edited lines: a picture and a note about it, or what is wrong with one of the
 * lines.
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

/** The value of each parameter, keyed by its id. */
type ParameterValues = Record<string, number>;

interface ParameterAbout {
  id: string;
  default: number;
  min: number;
  max: number;
  step: number;
  axis: "right" | "up" | "down" | null;
}

interface HandleAbout {
  label: string;
  mark: "point" | "light" | "probe";
  /** The ids of the parameters that it sets. */
  horizontal: string;
  vertical: string;
  depth: string | null;
  /** The id of the switch that adds the handle's object to the scene. */
  presence: string | null;
}

interface FigureAbout {
  parameters: ParameterAbout[];
  handles: HandleAbout[];
  /** The number of columns of a picture at full size; null for a drawing. */
  columns: number | null;
  /** Only for an editable scene: for each object, the ids of the three channels of its colour. */
  colours?: Record<string, string[]>;
}

interface FigureReply extends Pixels {
  values: ParameterValues;
  texts: Record<string, string>;
  visible: Record<string, boolean>;
  positions: ([number, number] | null)[];
  readouts: Record<string, string>;
  drawing?: string;
  /** Only for an editable scene. */
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
  /** Its index in the list of handles. */
  index: number;
  /** The object that it moves, in an editable scene. */
  object: string | undefined;
  /** Its position in the last reply. */
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
  /** Whether it is a preview, which has no controls. */
  isPreview: boolean;
  stage: HTMLElement;
  controls: HTMLElement;
  fault: HTMLElement;
  output: HTMLElement;
  reset: HTMLButtonElement;
  /** The menu that chooses an object, in an editable scene. */
  objectSelect: HTMLSelectElement | null;
  /** Width and height, in the figure's own coordinates. */
  size: number[];
  /** Has this called each time a reply has been shown. */
  afterShow(callback: () => void): void;
  /** Has this called each time the controls have been shown. */
  afterControls(callback: () => void): void;
  setValue(id: string, value: number): void;
  /** Whether there is something to show if one of the values is this. */
  canShow(id: string, value: number): boolean;
  controlOf(id: string): Control;
  selectObject(object: string | undefined): void;
  draw(): void;
  drawMoving(gesture: Gesture): void;
  drawNextFrame(gesture: Gesture): void;
  show(reply: FigureReply): void;
  positionOfPointer(pointer: { clientX: number, clientY: number }): [number, number];
}

/** A line in a listing that the reader may edit. */
interface EditedLine extends HTMLElement {
  /** The HTML of the book's text, including its colours. */
  bookHTML?: string;
}

// What the browser's own types don't cover.

interface ParentNode {
  querySelector<K extends keyof HTMLElementTagNameMap>(selectors: K): HTMLElementTagNameMap[K];
  querySelectorAll<K extends keyof HTMLElementTagNameMap>(selectors: K): NodeListOf<HTMLElementTagNameMap[K]>;
  /**
   * The caller knows what the builder has printed. If it needs more than an `HTMLElement`, it names
   * the type.
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
