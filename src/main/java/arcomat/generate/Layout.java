package arcomat.generate;

import arcomat.source.Span;

import java.util.List;
import java.util.Map;

/**
 * Where the parts of a model are found in the generated code, for those who drive it.
 *
 * @param components by qualified name of the model component
 * @param classes by qualified name of the class of a class diagram
 * @param programs qualified name of the main class, by qualified name of the component that it runs
 */
public record Layout(
        Map<String, Place> components,
        Map<String, MessageClass> classes,
        Map<String, String> programs) {
    /** Of nothing. */
    static final Layout NONE = new Layout(Map.of(), Map.of(), Map.of());

    public Layout {
        components = Map.copyOf(components);
        classes = Map.copyOf(classes);
        programs = Map.copyOf(programs);
    }

    /**
     * A class of messages; its constructor takes the attributes.
     *
     * @param attributes fields in the order of the model
     */
    public record MessageClass(String className, List<String> attributes) {}

    /**
     * The class of a component.
     *
     * @param className qualified
     * @param draws whether its constructor takes the generator of choices first
     * @param senses whether it has a method {@code sense} to be called before the slice is looked
     *     at: a platform component with outputs is inside
     * @param messages field with the message of a port, by the name of the port
     * @param presences field that says whether there is a message; missing for enums and total
     *     ports
     * @param methods event-driven: method that takes or sends a message, by the name of the port
     * @param variables field by the name of the variable
     * @param state field with the code of the state; empty where there is no automaton
     * @param queued event-driven: field with the number of events that wait
     * @param border event-driven: field for who sees what is sent
     * @param taken field with the index of the transition last taken, -1 for a completion; there
     *     where that is asked for
     * @param parts fields that lead to a node, by its path: {@code section1.cells[3]}
     * @param span the component in the model
     */
    public record Place(
            String className,
            boolean draws,
            boolean senses,
            Map<String, String> messages,
            Map<String, String> presences,
            Map<String, String> methods,
            Map<String, String> variables,
            String state,
            String taken,
            String queued,
            String border,
            Map<String, String> parts,
            Span span) {}
}
