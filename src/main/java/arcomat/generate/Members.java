package arcomat.generate;

import arcomat.generate.language.Language;
import arcomat.generate.language.Scope;
import arcomat.generate.language.Words;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.semantics.network.Composition;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The names of the members of one generated component. What the model names comes first and keeps
 * its name; names of the tool's own give way.
 */
final class Members {
    private final Map<String, String> ports = new LinkedHashMap<>();
    private final Map<String, String> flags = new LinkedHashMap<>();
    private final Map<String, String> parameters = new LinkedHashMap<>();
    private final Map<String, String> variables = new LinkedHashMap<>();
    private final Map<String, String> locals = new LinkedHashMap<>();
    private final Map<String, String> parts = new LinkedHashMap<>();
    private final List<String> states = new ArrayList<>();
    private final Map<String, String> methods = new LinkedHashMap<>();
    private final boolean timed;
    private final Scope scope;
    private final String state;
    private final String taken;

    /**
     * @param visible names of types that the members must not hide
     */
    Members(Component component, Optional<Composition> composition, Names visible) {
        Language language = visible.language();
        scope = visible.scope();
        timed = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        component.ports().forEach(p -> ports.put(p.name(), claim(p.name())));
        component.parameters().forEach(p -> parameters.put(p.name(), claim(p.name())));
        component.constants().forEach(v -> variables.put(v.name(), claim(v.name())));
        Optional<Automaton> automaton = automaton(component);
        automaton.ifPresent(
                a -> a.variables().forEach(v -> variables.put(v.name(), claim(v.name()))));
        composition.ifPresent(c -> c.nodes().forEach(n -> parts.put(n.path(), claim(n.path()))));
        for (Port port : component.ports()) {
            if (needsFlag(port, component.profile())) {
                String wanted = language.spellFlag(port.name(), Words.capitalised(port.name()));
                flags.put(port.name(), claim(wanted));
            }
        }
        automaton.ifPresent(
                a -> a.states().forEach(s -> states.add(scope.claim(Words.constant(s)))));
        Scope methodNames = Scope.of(language.reserved());
        Arrays.asList(language.words("reserved.methods")).forEach(methodNames::claim);
        for (Port port : component.ports()) {
            String wanted = port.isInput() ? port.name() : "send" + Words.capitalised(port.name());
            methods.put(port.name(), methodNames.claim(Words.identifier(wanted)));
        }
        state = claim("state");
        taken = claim("taken");
    }

    /** What the surrounding program makes visible: the language and a scope with taken names. */
    record Names(Language language, Scope scope) {}

    /** The automaton that is the behaviour of an atomic component. */
    static Optional<Automaton> automaton(Component component) {
        return component.body() instanceof Component.Atomic atomic && !component.platform()
                ? atomic.automata().stream().findFirst()
                : Optional.empty();
    }

    /** Enum codes have 0 for no message; a total port always carries one. */
    static boolean needsFlag(Port port, Component.Profile profile) {
        boolean alwaysPresent = port.total() && profile == Component.Profile.TIME_SYNCHRONOUS;
        return !(port.type() instanceof Type.EnumType) && !alwaysPresent && port.first().isEmpty();
    }

    boolean mayBeAbsent(Port port) {
        return port.first().isEmpty() && !(port.total() && timed);
    }

    /** A free name for something of the tool's own. */
    String claim(String wanted) {
        return scope.claim(Words.identifier(wanted));
    }

    /** The name of a local variable made from two words; the same for the same words. */
    String local(String first, String second) {
        return locals.computeIfAbsent(
                first + " " + second, key -> claim(first + Words.capitalised(second)));
    }

    String of(Port port) {
        return ports.get(port.name());
    }

    /** Event-driven: the method that takes or sends the messages of a port. */
    String method(Port port) {
        return methods.get(port.name());
    }

    /** The presence flag; empty where the port needs none. */
    String flag(Port port) {
        return flags.getOrDefault(port.name(), "");
    }

    String of(Parameter parameter) {
        return parameters.get(parameter.name());
    }

    String of(Variable variable) {
        return variables.get(variable.name());
    }

    /** The field of a node of the composition. */
    String part(String path) {
        return parts.get(path);
    }

    /** The named constant of a state. */
    String state(int index) {
        return states.get(index);
    }

    String state() {
        return state;
    }

    String taken() {
        return taken;
    }

    Map<String, String> ports() {
        return ports;
    }

    Map<String, String> flags() {
        return flags;
    }

    Map<String, String> methods() {
        return methods;
    }

    Map<String, String> variables() {
        return variables;
    }
}
