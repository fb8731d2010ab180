use compare::workspace;
use live::Answer;
use std::fs;
use wasmi::{
    CompilationMode, Config, Engine, Instance, Linker, Memory, Store, WasmParams,
    WasmResults,
};

/// The module `name`, as it is checked in.
pub fn checked_in(name: &str) -> Vec<u8> {
    let path = workspace().join(format!("book/wasm/{name}.wasm"));
    fs::read(path).expect("the module can be read")
}

/// A module that is read, and can be started again and again.
pub struct Code(wasmi::Module);

/// A module, running as in a page.
pub struct Module {
    store: Store<()>,
    instance: Instance,
    memory: Memory,
}

impl Code {
    pub fn new(bytes: &[u8]) -> Self {
        let mut config = Config::default();
        // Most functions are called by few tests.
        config.compilation_mode(CompilationMode::Lazy);
        let engine = Engine::new(&config);
        Self(wasmi::Module::new(&engine, bytes).expect("a module"))
    }

    /// Starts the module, which asks nothing of its page.
    pub fn start(&self) -> Module {
        let mut store = Store::new(self.0.engine(), ());
        let linker = Linker::new(self.0.engine());
        let instance =
            linker.instantiate_and_start(&mut store, &self.0).expect("it starts");
        let memory = instance.get_memory(&store, "memory").expect("it has memory");
        Module { store, instance, memory }
    }
}

impl Module {
    /// Its answer to a request about a file, as book/theme/live.js gets it; none where
    /// it fails.
    pub fn answer(&mut self, request: &str, file: &[u8]) -> Option<Answer> {
        for (room, bytes) in
            [("live_request", request.as_bytes()), ("live_file", file)]
        {
            let at: u32 = self.call(room, bytes.len() as u32)?;
            self.memory.write(&mut self.store, at as usize, bytes).ok()?;
        }
        self.call::<_, ()>("live_answer", ())?;
        let text = self.bytes("live_text", "live_text_length")?;
        let pixels = self.bytes("live_pixels", "live_pixels_length")?;
        Some(Answer { text: String::from_utf8(text).ok()?, pixels })
    }

    fn bytes(&mut self, at: &str, length: &str) -> Option<Vec<u8>> {
        let at: u32 = self.call(at, ())?;
        let length: u32 = self.call(length, ())?;
        let memory = self.memory.data(&self.store);
        Some(memory.get(at as usize..)?.get(..length as usize)?.to_vec())
    }

    fn call<P: WasmParams, R: WasmResults>(
        &mut self,
        name: &str,
        parameters: P,
    ) -> Option<R> {
        let function = self.instance.get_typed_func(&self.store, name).ok()?;
        function.call(&mut self.store, parameters).ok()
    }
}
