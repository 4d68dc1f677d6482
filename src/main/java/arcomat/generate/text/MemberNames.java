package arcomat.generate.text;

import arcomat.generate.language.NameForms;
import arcomat.generate.language.TargetLanguage;
import arcomat.generate.language.UniqueNames;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.semantics.network.Composition;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * The names of the members of one generated component. What the model names comes first and keeps
 * its name; names of the tool's own give way.
 */
public final class MemberNames {
    private final Map<String, String> ports = new LinkedHashMap<>();
    private final Map<String, String> flags = new LinkedHashMap<>();
    private final Map<String, String> parameters = new LinkedHashMap<>();
    private final Map<String, String> variables = new LinkedHashMap<>();
    private final Map<String, String> locals = new LinkedHashMap<>();
    private final Map<String, String> parts = new LinkedHashMap<>();
    private final List<String> states = new ArrayList<>();
    private final Map<String, String> methods = new LinkedHashMap<>();
    private final UniqueNames free;
    private final String state;
    private final String taken;

    /**
     * @param free has the names of types that the members must not hide
     */
    MemberNames(
            Component component,
            Optional<Composition> composition,
            TargetLanguage language,
            UniqueNames free) {
        this.free = free;
        component.ports().forEach(p -> ports.put(p.name(), claim(p.name())));
        component.parameters().forEach(p -> parameters.put(p.name(), claim(p.name())));
        component.constants().forEach(v -> variables.put(v.name(), claim(v.name())));
        Optional<Automaton> automaton = automaton(component);
        automaton.ifPresent(
                a -> a.variables().forEach(v -> variables.put(v.name(), claim(v.name()))));
        composition.ifPresent(c -> c.nodes().forEach(n -> parts.put(n.path(), claim(n.path()))));
        for (Port port : component.ports()) {
            if (needsFlag(port, component.profile())) {
                flags.put(port.name(), claim(language.flag(port.name())));
            }
        }
        automaton.ifPresent(
                a -> a.states().forEach(s -> states.add(free.claim(NameForms.constant(s)))));
        UniqueNames methodNames = language.unreserved("reserved.methods");
        for (Port port : component.ports()) {
            String wanted =
                    port.isInput() ? port.name() : "send" + NameForms.capitalised(port.name());
            methods.put(port.name(), methodNames.claim(NameForms.identifier(wanted)));
        }
        state = claim("state");
        taken = claim("taken");
    }

    /** The automaton that is the behaviour of an atomic component. */
    public static Optional<Automaton> automaton(Component component) {
        return component.body() instanceof Component.Atomic atomic && !component.platform()
                ? atomic.automata().stream().findFirst()
                : Optional.empty();
    }

    /** Enum codes have 0 for no message; a total port always carries one. */
    private static boolean needsFlag(Port port, Component.Profile profile) {
        boolean alwaysPresent = port.total() && profile == Component.Profile.TIME_SYNCHRONOUS;
        return !(port.type() instanceof Type.EnumType) && !alwaysPresent && port.first().isEmpty();
    }

    /** A free name for something of the tool's own. */
    public String claim(String wanted) {
        return free.claim(NameForms.identifier(wanted));
    }

    /** The name of a local variable made from two words; the same for the same words. */
    public String local(String first, String second) {
        return locals.computeIfAbsent(
                first + " " + second, key -> claim(first + NameForms.capitalised(second)));
    }

    public String local(String word) {
        return local(word, "");
    }

    /** One of several that are numbered. */
    public String local(String word, int number) {
        return local(word, String.valueOf(number));
    }

    public String of(Port port) {
        return Objects.requireNonNull(ports.get(port.name()));
    }

    /** Event-driven: the method that takes or sends the messages of a port. */
    public String method(Port port) {
        return Objects.requireNonNull(methods.get(port.name()));
    }

    /** The presence flag; empty where the port needs none. */
    public String flag(Port port) {
        return flags.getOrDefault(port.name(), "");
    }

    public String of(Parameter parameter) {
        return Objects.requireNonNull(parameters.get(parameter.name()));
    }

    /** The field of a variable, or a local variable where the component has no such field. */
    public String of(Variable variable) {
        String field = variables.get(variable.name());
        if (field != null) {
            return field;
        }
        String[] words = variable.name().split(" ", 2);
        return local(words[0], words.length == 1 ? "" : words[1].replace(' ', '_'));
    }

    /** The field of a node of the composition. */
    public String part(Composition.Node node) {
        return Objects.requireNonNull(parts.get(node.path()));
    }

    /** The named constant of a state. */
    public String state(int index) {
        return states.get(index);
    }

    /** The field with the code of the state. */
    public String state() {
        return state;
    }

    /** The field with the index of the transition that was taken last. */
    public String taken() {
        return taken;
    }

    /** Fields of messages by the names of their ports. */
    public Map<String, String> ports() {
        return Map.copyOf(ports);
    }

    /** Presence flags by the names of the ports that need them. */
    public Map<String, String> flags() {
        return Map.copyOf(flags);
    }

    /** Methods that take or send a message, by the names of the ports. */
    public Map<String, String> methods() {
        return Map.copyOf(methods);
    }

    /** Fields of variables and constants by their names in the model. */
    public Map<String, String> variables() {
        return Map.copyOf(variables);
    }
}
