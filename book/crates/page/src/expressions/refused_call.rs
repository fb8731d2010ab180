//! Explains why a function can't be called, or why a value has the wrong type.

use crate::expressions::compiler::Compiler;
use crate::expressions::functions::{Function, find_function, functions};
use crate::expressions::near_name::{find_near_name, name_and_synonyms};
use crate::expressions::operation::{OperationKind, range_of, write_without_spaces};
use crate::expressions::part::Part;
use crate::expressions::refusal::{Fault, Refusal};
use crate::expressions::statements::is_compound_assignment;
use crate::expressions::value::{describe_types, verb_and_count};
use course::ValueType;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::iter::once;
use std::ops::Range;
use syn::Expr;

/// An operation in a line, with its compiled operands.
pub struct Call<'a> {
    /// The whole expression.
    pub syntax: &'a Expr,
    pub kind: OperationKind,
    /// The name of the operation, as in [`Operation`](super::operation::Operation).
    pub name: &'a str,
    /// The range of the name in the line.
    pub name_range: Range<usize>,
    /// The operands in their order in the line. For a method or a field, the first is the receiver.
    pub operands: &'a [Part],
}

impl Call<'_> {
    /// The types of the operands.
    fn operand_types(&self) -> Vec<ValueType> {
        self.operands.iter().map(|operand| operand.code.value_type).collect()
    }

    /// The fields and methods that the first operand's type has.
    fn members(&self) -> impl Iterator<Item = &'static Function> {
        self.operands.first().into_iter().flat_map(|receiver| members(receiver.code.value_type))
    }

    /// Finds a function that has the operation's kind and name, ignoring the types of the operands.
    fn find_any_function(&self) -> Option<&'static Function> {
        functions().find(|function| function.is_named(self.kind, self.name))
    }
}

/// Explains that a part should have the type `wanted`. If the part is an i32 and `wanted` is f64 or
/// a vector, the explanation begins with what to write instead. Any other explanation begins with
/// `subject`.
pub fn explain_mismatch(subject: &str, part: &Part, text: &str, wanted: ValueType) -> Fault {
    use ValueType::{Array, Bool, F64, I32, Vector};
    let (actual, text) = (part.code.value_type, &text[part.range.clone()]);
    let cure = match (actual, wanted) {
        (I32, F64 | Vector) => {
            let is_literal = text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'_');
            let cure = match is_literal {
                true => format!("{text}.0"),
                false => format!("f64::from{}", ensure_parentheses(text)),
            };
            return Fault::WholeNumber { cure };
        }
        (_, Bool) => " Compare something, as in a < b.",
        (Bool, F64) => " f64::from(a < b) is a number, 1 or 0.",
        (Bool, Vector) => " if a < b { DVec3::X } else { DVec3::Y } makes a vector of it.",
        (Vector, F64) => " a.dot(b) makes a number of two vectors.",
        (F64, Vector) => " DVec3::splat(…) makes a vector of it.",
        (Array, Vector) => " DVec3::from(…) makes a vector of it.",
        (F64, I32) if subject.starts_with(".powi") => " Write 2, or use .powf.",
        (F64, I32) => " as i32 makes one of it, without its fraction.",
        _ => "",
    };
    Fault::Mismatch { subject: subject.to_owned(), wanted, actual, cure }
}

/// Whether values of this type have a method with this name.
fn is_method(receiver: ValueType, name: &str) -> bool {
    members(receiver)
        .any(|function| function.kind == OperationKind::Method && function.name == name)
}

/// The fields and methods of a type.
fn members(receiver: ValueType) -> impl Iterator<Item = &'static Function> {
    functions().filter(move |function| {
        function.kind.is_member() && function.parameters.first() == Some(&receiver)
    })
}

/// Writes a member as it appears in a line: `x` for a field, and `length()` or `dot(…)` for a
/// method.
fn member_as_typed(Function { kind, name, parameters, .. }: &Function) -> String {
    match parameters {
        _ if *kind == OperationKind::Field => (*name).to_owned(),
        [_] => format!("{name}()"),
        _ => format!("{name}(…)"),
    }
}

/// Puts parentheses around an expression that isn't in parentheses already.
fn ensure_parentheses(text: &str) -> String {
    let has_them = matches!(syn::parse_str(text), Ok(Expr::Paren(_)));
    if has_them { text.to_owned() } else { format!("({text})") }
}

/// Whether a method can be called on this expression without putting the expression in parentheses.
fn is_atomic(text: &str) -> bool {
    matches!(
        syn::parse_str(text),
        Ok(Expr::Array(_)
            | Expr::Call(_)
            | Expr::Field(_)
            | Expr::Index(_)
            | Expr::Lit(_)
            | Expr::MethodCall(_)
            | Expr::Paren(_)
            | Expr::Path(_))
    )
}

/// Whether two chains such as `sphere.centre` are nearly equal: both have the same number of names,
/// and corresponding names are equal or nearly equal.
fn is_near_chain(name: &str, known_name: &str) -> bool {
    let is_near =
        |(word, known_name): (&str, &str)| find_near_name(word, once(known_name)).is_some();
    name.matches('.').count() == known_name.matches('.').count()
        && name
            .split('.')
            .zip(known_name.split('.'))
            .all(|words| words.0 == words.1 || is_near(words))
}

impl Compiler<'_> {
    /// Explains why a call isn't possible. The refusal contains the range to mark in the line.
    pub fn explain_refused_call(&self, call: &Call) -> Refusal {
        if call.kind.is_member() && !call.members().any(|member| member.name == call.name) {
            return self.explain_unknown_member(call);
        }
        if let Some(refusal) = self.explain_single_wrong_type(call) {
            return refusal;
        }
        let refusal = |fault| Refusal { range: call.name_range.clone(), fault };
        match call.kind {
            OperationKind::Path => self.explain_refused_path(call),
            OperationKind::Method | OperationKind::Field => self.explain_misused_member(call),
            OperationKind::Operator => self.explain_refused_operator(call),
            OperationKind::Cast => refusal(Fault::Cast),
            OperationKind::Index => refusal(Fault::Index),
            OperationKind::Array if call.operands.len() != 3 => refusal(Fault::ArrayLength),
            OperationKind::Array => self.explain_wrong_operands(call, &[ValueType::F64; 3]),
        }
    }

    /// If the call would be valid with a different type for a single operand, explains that this
    /// operand has the wrong type. Otherwise returns None.
    fn explain_single_wrong_type(&self, call: &Call) -> Option<Refusal> {
        let types = call.operand_types();
        let mut wanted_types = ValueType::ALL;
        if types.contains(&ValueType::Array) {
            // An array is most likely meant to be a vector, so try vectors first.
            let vector =
                wanted_types.iter().position(|value_type| *value_type == ValueType::Vector);
            wanted_types[..=vector.unwrap_or(0)].rotate_right(1);
        }
        // Skip a receiver. `explain_refused_call` has checked that the receiver's type has a field
        // or method with this name.
        let first = usize::from(call.kind.is_member());
        for value_type in wanted_types {
            for (index, operand) in call.operands.iter().enumerate().skip(first).rev() {
                let mut other_types = types.clone();
                other_types[index] = value_type;
                if find_function(call.kind, call.name, &other_types).is_some() {
                    return Some(self.explain_operand_type(call, operand, value_type));
                }
            }
        }
        None
    }

    /// Explains that an operand should have the type `wanted`.
    fn explain_operand_type(&self, call: &Call, operand: &Part, wanted: ValueType) -> Refusal {
        let subject = format!("{} takes", self.name_in_line(call));
        let fault = explain_mismatch(&subject, operand, self.text, wanted);
        Refusal { range: operand.range.clone(), fault }
    }

    /// The name of the operation, as it is written in the line.
    fn name_in_line(&self, call: &Call) -> String {
        self.text[call.name_range.clone()].to_owned()
    }

    /// Explains why a path can't be called, or why it has no value.
    fn explain_refused_path(&self, call: &Call) -> Refusal {
        match call.find_any_function() {
            Some(Function { parameters: [], .. }) => {
                let fault = Fault::NoFunction { cure: self.name_in_line(call) };
                Refusal { range: range_of(call.syntax), fault }
            }
            Some(function) => self.explain_wrong_operands(call, function.parameters),
            None if call.name.contains(char::is_alphanumeric) => self.explain_unknown_name(call),
            // The expression in front of the arguments isn't a name, as in `_(d)` or `()(d)`.
            None => {
                let fault = Fault::Operator(call.name.to_owned());
                Refusal { range: call.name_range.clone(), fault }
            }
        }
    }

    /// Explains why an operator can't be applied.
    fn explain_refused_operator(&self, call: &Call) -> Refusal {
        let fault = match (call.find_any_function(), call.syntax) {
            (Some(function), _) => return self.explain_wrong_operands(call, function.parameters),
            (None, _) if call.name == "^" => Fault::Caret,
            (None, Expr::Binary(binary)) if is_compound_assignment(&binary.op) => {
                Fault::CompoundAssignment(call.name.to_owned())
            }
            (None, _) => Fault::Operator(call.name.to_owned()),
        };
        Refusal { range: call.name_range.clone(), fault }
    }

    /// Explains the misuse of a field or method that the receiver does have.
    fn explain_misused_member(&self, call: &Call) -> Refusal {
        let range = call.name_range.start..range_of(call.syntax).end;
        let cure = |end| format!(".{}{end}", call.name);
        let members: Vec<_> = call.members().filter(|member| member.name == call.name).collect();
        let is_field = members.iter().any(|member| member.kind == OperationKind::Field);
        let needs_only_receiver = members.iter().any(|member| member.parameters.len() == 1);
        match (call.kind, &members[..]) {
            (OperationKind::Method, _) if is_field => {
                Refusal { range, fault: Fault::Field { cure: cure("") } }
            }
            (OperationKind::Field, _) if needs_only_receiver => {
                Refusal { range, fault: Fault::MissingParentheses { cure: cure("()") } }
            }
            (_, [first, ..]) => {
                let same_count =
                    members.iter().find(|member| member.parameters.len() == call.operands.len());
                self.explain_wrong_operands(call, same_count.unwrap_or(first).parameters)
            }
            (_, []) => Refusal { range, fault: Fault::Unsupported },
        }
    }

    /// Explains why the operands of a call don't fit a function with these parameters. Either the
    /// number of operands is wrong, or an operand has the wrong type.
    fn explain_wrong_operands(&self, call: &Call, parameters: &[ValueType]) -> Refusal {
        let mut pairs = call.operands.iter().zip(parameters);
        let mismatch = pairs.find(|(operand, wanted)| operand.code.value_type != **wanted);
        let fault = match mismatch {
            _ if parameters.len() != call.operands.len() => {
                // The counts don't include a receiver.
                let first = usize::from(call.kind.is_member());
                Fault::Count {
                    name: self.name_in_line(call),
                    wanted: describe_types(&parameters[first..]),
                    actual: verb_and_count(call.operands.len() - first),
                }
            }
            Some((operand, wanted)) => return self.explain_operand_type(call, operand, *wanted),
            None => Fault::Unsupported,
        };
        Refusal { range: call.name_range.clone(), fault }
    }

    /// Explains that the receiver has no field or method with the name in `call`. The explanation
    /// suggests a similar name, or says which other type has such a member, or lists the receiver's
    /// members. For `.into()`, the explanation suggests what to write instead.
    fn explain_unknown_member(&self, call: &Call) -> Refusal {
        let Call { syntax, kind, name: member, operands, .. } = *call;
        let name_range = call.name_range.clone();
        let receiver = &operands[0];
        let (text, value_type) = (&self.text[receiver.range.clone()], receiver.code.value_type);
        if kind == OperationKind::Method && member == "into" && operands.len() == 1 {
            let cure = match value_type {
                ValueType::Array => format!("DVec3::from{}", ensure_parentheses(text)),
                ValueType::I32 | ValueType::Bool => {
                    format!("f64::from{}", ensure_parentheses(text))
                }
                ValueType::F64 | ValueType::Vector => text.to_owned(),
            };
            return Refusal { range: range_of(syntax), fault: Fault::Into { cure } };
        }
        let name = format!(".{member}");
        let types = call.operand_types();
        let mut candidates = name_and_synonyms(member)
            .into_iter()
            .filter(|name| find_function(OperationKind::Method, name, &types).is_some());
        let near_name = candidates.next().or_else(|| {
            let names = members(value_type).map(|candidate| candidate.name);
            find_near_name(member, names).map(str::to_owned)
        });
        let near_member = near_name.and_then(|near_name| {
            members(value_type).find(|candidate| candidate.name == near_name)
        });
        if let Some(near_member) = near_member {
            let (end, near_name) = match (kind, near_member.kind) {
                // The line already has parentheses after the name.
                (OperationKind::Method, OperationKind::Method) => {
                    (name_range.end, near_member.name.to_owned())
                }
                _ => (range_of(syntax).end, member_as_typed(near_member)),
            };
            let fault = Fault::NearName { name, near_name: format!(".{near_name}") };
            return Refusal { range: name_range.start..end, fault };
        }
        let owner = ValueType::ALL.into_iter().find(|value_type| {
            *value_type != receiver.code.value_type
                && members(*value_type).any(|candidate| candidate.name == member)
        });
        let fault = match owner {
            Some(owner) => Fault::OtherReceiver { name, owner, receiver: value_type },
            None => {
                let members = members(value_type).map(member_as_typed);
                let members: Vec<_> = members.collect::<BTreeSet<_>>().into_iter().collect();
                Fault::UnknownMember { name, receiver: value_type, members: members.join(", ") }
            }
        };
        Refusal { range: name_range, fault }
    }

    /// Explains that the name in `call` is unknown. The explanation suggests a method, a similar
    /// name or a way to write a vector, or lists the place's variables. The call has operands only
    /// if the line uses the name as a function. In that case, the operands are the function's
    /// arguments.
    fn explain_unknown_name(&self, call: &Call) -> Refusal {
        let Call { syntax, name, operands, .. } = *call;
        if let Some(cure) = self.write_as_method(name, operands) {
            let has_ambiguous_type = operands[0].code.has_ambiguous_type;
            let fault =
                if has_ambiguous_type { Fault::Function { cure } } else { Fault::Method { cure } };
            return Refusal { range: range_of(syntax), fault };
        }
        let fault = match self.find_near_name_or_path(name) {
            Some(near_name) => Fault::NearName { name: name.to_owned(), near_name },
            None if name.to_ascii_lowercase().contains("vec3") && !self.place.has_vectors => {
                Fault::NoVectors
            }
            None if name.to_ascii_lowercase().contains("vec3") => {
                let cure = "DVec3::new(1.0, 0.0, 0.5) is a vector.".to_owned();
                Fault::UnknownName { name: name.to_owned(), cure }
            }
            None => {
                let variables = self.place.variables.iter().map(|(name, _)| *name);
                let cure = format!("These are:\n{}", variables.collect::<Vec<_>>().join(", "));
                Fault::UnknownName { name: name.to_owned(), cure }
            }
        };
        Refusal { range: call.name_range.clone(), fault }
    }

    /// Rewrites a function call as a method call: `sqrt(d)` as `d.sqrt()`, for example. Returns
    /// None if the first argument has no method with this name or a synonym of it.
    fn write_as_method(&self, name: &str, operands: &[Part]) -> Option<String> {
        let last_name = name.rsplit("::").next().unwrap_or_default();
        let (first_operand, other_operands) = operands.split_first()?;
        let value_type = first_operand.code.value_type.name();
        let types: Vec<_> = operands.iter().map(|operand| operand.code.value_type).collect();
        let mut methods = name_and_synonyms(last_name);
        methods.retain(|method| is_method(first_operand.code.value_type, method));
        let fits = |method: &&String| find_function(OperationKind::Method, method, &types);
        let method = methods.iter().find(|method| fits(method).is_some());
        let texts = other_operands.iter().map(|operand| &self.text[operand.range.clone()]);
        let other_arguments = match method {
            Some(_) => texts.collect::<Vec<_>>().join(", "),
            None => "…".to_owned(),
        };
        let method = method.or(methods.first())?;
        let text = &self.text[first_operand.range.clone()];
        Some(if first_operand.code.has_ambiguous_type {
            // No method can be called on a literal such as 2.0, because Rust doesn't know its type
            // yet.
            let comma = if other_arguments.is_empty() { "" } else { ", " };
            format!("{value_type}::{method}({text}{comma}{other_arguments})")
        } else if is_atomic(text) {
            format!("{text}.{method}({other_arguments})")
        } else {
            format!("({text}).{method}({other_arguments})")
        })
    }

    /// Finds a known name that is close to `name`: a variable, or the path of a function or
    /// constant.
    fn find_near_name_or_path(&self, name: &str) -> Option<String> {
        let variables = || self.names.iter().map(|(variable, _)| &**variable);
        let converted_name = format!("f64::from({name})");
        let variable = variables().find(|variable| *variable == converted_name);
        if let Some(variable) = variable.or_else(|| find_near_name(name, variables())) {
            return Some(self.restore_spaces_in_name(variable));
        }
        let is_here = |path: &Cow<str>| self.place.has_vectors || !path.starts_with("DVec3");
        let paths: Vec<_> =
            functions().filter_map(Function::qualified_name).filter(is_here).collect();
        // The last name in a path, such as PI in std::f64::consts::PI.
        let last_name =
            |path: &str| path.rsplit("::").next().unwrap_or_default().to_ascii_lowercase();
        let find_by_last_name = |wanted: &str| {
            let mut paths = paths.iter().filter(|path| last_name(path) == wanted);
            // Prefer functions of the type in `name`: those of DVec3 for `DVec3::normalise`.
            let owner = name.split("::").next().unwrap_or_default();
            let path_of_owner = paths.clone().find(|path| path.starts_with(owner));
            path_of_owner.or_else(|| paths.next()).map(|path| path.clone().into_owned())
        };
        let word = last_name(name);
        let path_of_same_name = (name.len() > 1).then(|| find_by_last_name(&word)).flatten();
        path_of_same_name.or_else(|| {
            let last_names: Vec<_> = paths.iter().map(|path| last_name(path)).collect();
            find_by_last_name(find_near_name(&word, last_names.iter().map(|name| &**name))?)
        })
    }

    /// Restores the spaces in a variable's name: returns the name as it is written in places.txt.
    /// If the place has no such variable, returns `name_without_spaces`.
    fn restore_spaces_in_name(&self, name_without_spaces: &str) -> String {
        let variables = self.place.variables.iter().map(|(name, _)| *name);
        let mut names = variables
            .filter(|name| name.split_whitespace().collect::<String>() == name_without_spaces);
        names.next().unwrap_or(name_without_spaces).to_owned()
    }

    /// Refuses an unknown chain, such as `hit.object.name`. The chain is refused if a known name,
    /// such as `hit.t`, begins with `hit.`, and none of `hit`, `hit.object` and `hit.object.name`
    /// is a known name.
    pub fn refuse_unknown_chain(&self, syntax: &Expr) -> Option<Refusal> {
        let mut links = vec![syntax];
        while let Some(inner) = links.last().and_then(|link| match link {
            Expr::Field(field) => Some(&*field.base),
            Expr::MethodCall(call) => Some(&*call.receiver),
            _ => None,
        }) {
            links.push(inner);
        }
        let is_name = |name: &str| self.names.iter().any(|(known_name, _)| *known_name == name);
        let begins_name = |name: &str| {
            let suffix =
                |(known_name, _): &(String, _)| known_name.strip_prefix(name).map(str::to_owned);
            self.names
                .iter()
                .any(|entry| suffix(entry).is_some_and(|suffix| suffix.starts_with('.')))
        };
        let names: Vec<_> = links.iter().map(|link| write_without_spaces(*link)).collect();
        let root = names.last()?;
        if !begins_name(root) || names.iter().any(|name| is_name(name)) {
            return None;
        }
        let variables = || self.names.iter().map(|(known_name, _)| &**known_name);
        let near_fault = links.iter().zip(&names).find_map(|(link, name)| {
            let near_name = self.restore_spaces_in_name(
                variables().find(|variable| is_near_chain(name, variable))?,
            );
            let range = range_of(*link);
            let name = self.text[range.clone()].to_owned();
            Some((range, Fault::NearName { name, near_name }))
        });
        let (range, fault) = near_fault.unwrap_or_else(|| {
            let index = names.iter().rposition(|name| !begins_name(name)).unwrap_or(0);
            let range = range_of(links[index]);
            let name = self.text[range.clone()].to_owned();
            let start = format!("{root}.");
            let variables_of_root = variables().filter(|variable| variable.starts_with(&start));
            let variables_of_root: Vec<_> =
                variables_of_root.map(|variable| self.restore_spaces_in_name(variable)).collect();
            let cure = format!("With {root}, you can write:\n{}", variables_of_root.join(", "));
            let fault = match links[index] {
                _ if begins_name(&names[index]) => Fault::PartOfName { name, cure },
                Expr::MethodCall(_) => Fault::UnknownCall { name, cure },
                _ => Fault::UnknownName { name, cure },
            };
            (range, fault)
        });
        Some(Refusal { range, fault })
    }

    /// Refuses a call such as `direction_colour(ray)` if the function is unknown and an argument is
    /// an unknown chain. Without this check, the refusal would be about the argument, but a correct
    /// argument wouldn't help the reader, because the function can't be called at all.
    pub fn refuse_unknown_function_with_unknown_argument(&self, syntax: &Expr) -> Option<Refusal> {
        let Expr::Call(call) = syntax else { return None };
        let name = write_without_spaces(&call.func);
        let last_name = name.rsplit("::").next().unwrap_or_default();
        let is_method =
            |name: &String| ValueType::ALL.into_iter().any(|kind| is_method(kind, name));
        let is_known = functions().any(|function| function.is_named(OperationKind::Path, &name));
        if is_known || name_and_synonyms(last_name).iter().any(is_method) {
            return None;
        }
        let mut arguments = call.args.iter();
        let has_unknown_chain =
            arguments.any(|argument| self.refuse_unknown_chain(argument).is_some());
        has_unknown_chain.then(|| {
            let name_range = range_of(&call.func);
            let kind = OperationKind::Path;
            self.explain_unknown_name(&Call {
                syntax,
                kind,
                name: &name,
                name_range,
                operands: &[],
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use course::all_listed_places;

    #[test]
    fn chain_is_near_if_each_of_its_words_is() {
        assert!(is_near_chain("sphere.center", "sphere.centre"));
        assert!(is_near_chain("spere.centre", "sphere.centre"));
        for name in ["sphere", "sphere.radius", "sphere.centre.x"] {
            assert!(!is_near_chain(name, "sphere.centre"), "{name}");
        }
    }

    #[test]
    fn parentheses_are_not_doubled() {
        for (text, in_them) in
            [("a + b", "(a + b)"), ("(a + b)", "(a + b)"), ("(a) + (b)", "((a) + (b))")]
        {
            assert_eq!(ensure_parentheses(text), in_them);
        }
    }

    #[test]
    fn text_is_atomic_if_a_method_call_on_it_needs_no_parentheses() {
        for text in ["a", "2.0", "v.x", "v.dot(v)", "f(a)", "a[0]", "(a + b)"] {
            assert!(is_atomic(text), "{text}");
        }
        for text in ["a + b", "-a", "a as f64", "if a { b } else { c }"] {
            assert!(!is_atomic(text), "{text}");
        }
    }

    #[test]
    fn member_is_written_as_in_a_line() {
        let write = |value_type, name| {
            member_as_typed(
                members(value_type).find(|candidate| candidate.name == name).expect(name),
            )
        };
        assert_eq!(write(ValueType::Vector, "x"), "x");
        assert_eq!(write(ValueType::Vector, "length"), "length()");
        assert_eq!(write(ValueType::Vector, "dot"), "dot(…)");
    }

    #[test]
    fn near_path_is_a_name_of_the_place_or_a_function() {
        let places = all_listed_places();
        let place = places.iter().find(|place| place.name == "normal").expect("a place");
        let names = ["sphere.centre", "f64::from(n)"];
        let code = |compiler: &Compiler| compiler.code_of_free_slot(ValueType::F64, false);
        let mut compiler = Compiler { place, text: "", names: vec![] };
        compiler.names = names.map(|name| (name.to_owned(), code(&compiler))).into();
        for (name, near_name) in [
            ("sphere.center", Some("sphere.centre")),
            ("n", Some("f64::from(n)")),
            ("pi", Some("std::f64::consts::PI")),
            ("DVec3::normalise", Some("DVec3::normalize")),
            ("DVec3::flooor", Some("DVec3::floor")),
            ("flooor", Some("f64::floor")),
            ("teapot", None),
        ] {
            assert_eq!(compiler.find_near_name_or_path(name).as_deref(), near_name, "{name}");
        }
    }
}
