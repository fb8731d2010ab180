// The types of the scripts in book/theme: what they share, and what the modules reply. `npm run types` checks
// the scripts against them.

/** What the scripts of the pages share: the one name that they have in common. */
interface Book {
  /** The element `html`. */
  root: HTMLElement;

  // book.js

  /** An element with these attributes and children. */
  make<K extends keyof HTMLElementTagNameMap>(
    tag: K, attributes: Record<string, string | number | boolean>, ...children: (Node | string)[]
  ): HTMLElementTagNameMap[K];
  /** Writes a text, unless it is there already: then nothing is laid out anew. */
  write(element: Element, text: string): void;
  /** Runs a function that writes HTML, which is made by the scripts or the modules. */
  writeHTML(act: () => void): void;
  /** Lets the page load a script, or start a worker, from an address of its own. */
  trustAddress(address: string): void;
  /** Copies a text, if the browser lets a page do so, and says so on the button for a while. */
  copyBy(button: HTMLButtonElement, text: string, words?: string): Promise<void>;
  /** What the browser keeps under this name, by key; nothing if it keeps nothing. */
  recall(name: string): Record<string, any>;
  /** Lets the browser keep a value under a name and a key, if the reader allows that. */
  keep(name: string, key: string, value: string | boolean): void;
  /** Marks in the contents the steps whose picture was right. */
  markRight(): void;
  /** A number as people type it: 58.72, 58,72, 1/2, −3 or 60°. NaN if it isn't one. */
  readNumber(text: string): number;
  /** Calls `near`, once for each element, when the element comes near the view. */
  whenNear(elements: Iterable<HTMLElement> & { forEach(act: (element: HTMLElement) => void): void }, near: (element: HTMLElement) => void): void;
  /**
   * Loads a script once, after the others unless it is large, and says whether it has come. One that failed
   * is loaded again the next time.
   */
  load(file: string, isLarge?: boolean): Promise<boolean>;
  /** Colours a listing. */
  colourCode(code: Element): void;
  /** Colours a listing once the script for it has come, unless the listing is being edited. */
  colour(code: Element): void;
  /** States that can be undone and done again. */
  History: new <State>(state: State) => UndoHistory<State>;

  // wasm.js

  modules: {
    /** Keeps a file that a generated script contains. */
    provide(name: string, base64: string): void;
    /** Loads a module and what it needs, without starting it. */
    compile(name: string): Promise<CompiledModule>;
    /** The module of this name, started. */
    get(name: string): Promise<Module>;
    /** Forgets a module that failed: the next request starts it anew. */
    drop(name: string): void;
  };
  /** Starts a module, and gives it the list of mistakes if it needs that. */
  startModule(compiled: CompiledModule): Promise<Module>;
  /** The reply of a module to a request, about a file if there is one. */
  ask(module: Module, request: string, file?: Uint8Array): any;
  /** Puts the pixels of a reply on a canvas: all of them, or this many columns from one on. */
  paint(canvas: HTMLCanvasElement, reply: Pixels, column?: number, columns?: number): void;

  // handle.js, own_scene.js, figure.js

  /** A mark in a figure that the reader drags. */
  Handle: new (figure: InteractiveFigure, about: HandleAbout, index: number) => Handle;
  /** Adds the tools of an editable scene to its figure. */
  followScene(figure: InteractiveFigure): void;
  /** A request that the module has no reply to. */
  Refusal: new (message: string) => Error;

  // search-index.js

  /** For each page its name and its title, and the id, title, prose, listings and readers' phrases of each section. */
  searchIndex: [string, string, [string, string, string, string, string[]][]][];
  /** The section to read, the compiler's messages, and a sentence that says what to do. */
  searchHints: [string, string[], string][];
  /** Groups of words that mean nearly the same. */
  searchSynonyms: string[][];
}

interface UndoHistory<State> {
  /** Adds a state, unless it is the current one, and drops those that were undone. */
  record(state: State): void;
  /** Whether there is a state this many steps later, or earlier if negative. */
  has(steps: number): boolean;
  /** Goes that many steps, and returns the state there. */
  go(steps: number): State;
}

// The modules.

interface CompiledModule {
  module: WebAssembly.Module;
  mistakes?: Uint8Array;
}

interface Module {
  memory: WebAssembly.Memory;
  make_room(index: number, length: number): number;
  make_reply(): number;
}

interface Pixels {
  size?: [number, number];
  pixels?: Uint8ClampedArray<ArrayBuffer>;
}

/** The reply of `check` to a file: its exit code, and the lines of its answer, of which the first is the headline. */
interface CheckReply extends Pixels {
  code: number;
  lines: string[];
}

/** The reply to edited lines: a picture with what is known of it, or what is wrong with one of the lines. */
interface EditReply extends Pixels {
  known?: string;
  names?: string[];
  line?: string;
  from?: number;
  to?: number;
  mistake?: string;
}

// Figures, as the crate `figures` describes them.

/** The value of each parameter, by its id. */
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
  words: string;
  mark: "point" | "light" | "probe";
  /** The ids of the parameters that it sets. */
  horizontal: string;
  vertical: string;
  depth: string | null;
  /** The id of the switch that takes it into the scene. */
  presence: string | null;
}

interface FigureAbout {
  parameters: ParameterAbout[];
  handles: HandleAbout[];
  /** The columns of a picture that is drawn in full; null for a drawing. */
  columns: number | null;
  /** Of an editable scene: the ids of the channels of each object's colour. */
  colours?: Record<string, string[]>;
}

interface FigureReply extends Pixels {
  values: ParameterValues;
  texts: Record<string, string>;
  visible: Record<string, boolean>;
  positions: ([number, number] | null)[];
  readouts: Record<string, string>;
  drawing?: string;
  /** Of an editable scene. */
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
  /** Its number among the handles. */
  index: number;
  /** The object that it moves, in an editable scene. */
  object: string | undefined;
  grab(event: PointerEvent): void;
  changeDepth(length: number): void;
  show(): void;
}

interface InteractiveFigure {
  about: FigureAbout;
  parameters: Map<string, ParameterAbout>;
  values: ParameterValues;
  reply: FigureReply;
  handles: Handle[];
  probe: Handle | undefined;
  root: HTMLElement;
  stage: HTMLElement;
  controls: HTMLElement;
  fault: HTMLElement;
  output: HTMLElement;
  reset: HTMLButtonElement;
  /** The choice of an object, in an editable scene. */
  objectSelect: HTMLSelectElement | null;
  /** Width and height, in its own coordinates. */
  size: number[];
  /** Called after something was shown. */
  afterShow?: () => void;
  /** Called after the controls were shown. */
  afterControls?: () => void;
  request(verb: string, ...words: (string | number)[]): any;
  formatValues(): string;
  setValue(id: string, value: number): void;
  /** Whether there is something to show if one of the values is this. */
  canShow(id: string, value: number): boolean;
  controlOf(id: string): Control;
  selectObject(object: string | undefined): void;
  draw(): void;
  drawMoving(verb: string, ...words: number[]): void;
  drawNextFrame(verb: string, ...words: number[]): void;
  show(reply: FigureReply): void;
  positionOfPointer(pointer: { clientX: number, clientY: number }): number[];
}

/** A line of a listing that the reader may edit. */
interface EditedLine extends HTMLElement {
  /** The HTML of the book's text, with its colours. */
  bookHTML?: string;
}

// What the browser's own types leave open.

interface ParentNode {
  querySelector<K extends keyof HTMLElementTagNameMap>(selectors: K): HTMLElementTagNameMap[K];
  querySelectorAll<K extends keyof HTMLElementTagNameMap>(selectors: K): NodeListOf<HTMLElementTagNameMap[K]>;
  /** The caller knows what the builder printed, and names its type if it needs more than an element. */
  querySelector<E extends HTMLElement>(selectors: string): E;
  querySelectorAll<E extends HTMLElement>(selectors: string): NodeListOf<E>;
}

interface Window {
  hljs?: { highlightBlock(code: Element): void };
  MiniSearch?: unknown;
  trustedTypes?: { createPolicy(name: string, rules: Record<string, (text: string) => string | null>): void };
}

/** The library of the search. */
declare const MiniSearch: new (options: object) => any;
