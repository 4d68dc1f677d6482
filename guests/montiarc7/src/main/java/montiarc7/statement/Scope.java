package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.TypeContext;
import montiarc7.source.Lacks;
import montiarc7.source.TypeNames;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Where expressions and statements stand.
 *
 * @param present input ports that carry a message here
 * @param known what is known of local variables here
 * @param declared the types of names, as far as this component says them
 * @param events whether steps are events, and not slices
 */
public record Scope(
        TypeNames types,
        Set<String> inputs,
        Set<String> outputs,
        Set<String> present,
        Known known,
        Map<String, TypeContext> declared,
        boolean events,
        Lacks lacks) {
    /** Where nothing is known but ports that are read. */
    public static Scope ofPorts(Set<String> ports, Lacks lacks) {
        return new Scope(null, ports, Set.of(), Set.of(), Known.NOTHING, Map.of(), false, lacks);
    }

    public Scope with(Set<String> more) {
        Set<String> all = new HashSet<>(present);
        all.addAll(more);
        return new Scope(types, inputs, outputs, all, known, declared, events, lacks);
    }

    /** Whether a name is that of a port, a field or a parameter. */
    boolean isDeclared(String name) {
        return declared.containsKey(name) || inputs.contains(name) || outputs.contains(name);
    }

    /** Behind some of the statements of an action. */
    Scope within(Course course) {
        Map<String, TypeContext> all = new HashMap<>(declared);
        all.putAll(course.types);
        return new Scope(types, inputs, outputs, present, course.known, all, events, lacks);
    }

    /** At the start nothing has been received, and not all outputs are seen. */
    public Scope atStart(Set<String> seen) {
        return new Scope(types, inputs, seen, Set.of(), known, declared, events, lacks);
    }

    /** The same where what is wrong is told by somebody else. */
    Scope unheard() {
        Lacks unheard = lacks.unheard();
        return new Scope(types, inputs, outputs, present, known, declared, events, unheard);
    }
}
