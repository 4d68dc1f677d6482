package arcomat.generate;

import arcomat.generate.plan.AutomatonPlan;
import arcomat.generate.plan.Program;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.ClassView;
import arcomat.generate.views.MessageTypes;
import arcomat.model.Component;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Where the parts of a model are found in the generated code, for those who drive it.
 *
 * @param components by qualified name of the model component
 * @param classes by qualified name of the class of a class diagram
 * @param programs qualified name of the main class, by qualified name of the component that it runs
 * @param automata those of all components that have one, in the order of the files
 * @param wholes the components that programs run
 */
public record CodeLayout(
        Map<String, Place> components,
        Map<String, MessageClass> classes,
        Map<String, String> programs,
        List<AutomatonLines> automata,
        List<Component> wholes) {
    /** Of nothing. */
    static final CodeLayout NONE =
            new CodeLayout(Map.of(), Map.of(), Map.of(), List.of(), List.of());

    public CodeLayout {
        components = Map.copyOf(components);
        classes = Map.copyOf(classes);
        programs = Map.copyOf(programs);
        automata = List.copyOf(automata);
        wholes = List.copyOf(wholes);
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

    static CodeLayout of(
            Program program,
            MessageTypes types,
            List<Component> mains,
            List<AutomatonLines> automata) {
        Map<String, Place> places = new LinkedHashMap<>();
        for (FileContext context : program.contexts()) {
            places.put(context.component().qualifiedName(), place(context, program));
        }
        Map<String, MessageClass> classes = new LinkedHashMap<>();
        for (ClassView view : types.classes()) {
            List<String> attributes =
                    view.attributes().stream().map(ClassView.AttributeView::name).toList();
            classes.put(view.model(), new MessageClass(view.self().qualified(), attributes));
        }
        Map<String, String> programs = new LinkedHashMap<>();
        for (Component main : mains) {
            programs.put(main.qualifiedName(), program.nameOfProgram(main).qualified());
        }
        return new CodeLayout(places, classes, programs, automata, mains);
    }

    /** Of all components that have one, once their files are written. */
    static List<AutomatonLines> automata(Program program, OutputFiles output) {
        List<AutomatonLines> automata = new ArrayList<>();
        for (FileContext context : program.contexts()) {
            program.automaton(context.component())
                    .map(AutomatonPlan::automaton)
                    .map(
                            automaton ->
                                    new AutomatonLines(
                                            context.self().qualified(),
                                            context.component(),
                                            automaton,
                                            output.marks(context.self())))
                    .ifPresent(automata::add);
        }
        return automata;
    }

    private static Place place(FileContext context, Program program) {
        Component component = context.component();
        MemberNames members = context.members();
        boolean automaton = MemberNames.automaton(component).isPresent();
        return new Place(
                context.self().qualified(),
                program.draws(component),
                program.senses(component),
                members.ports(),
                members.flags(),
                members.methods(),
                members.variables(),
                automaton ? members.state() : "",
                automaton ? members.taken() : "",
                members.local("queued"),
                members.local("border"),
                context.composition().isPresent() ? program.arrangement(context).paths() : Map.of(),
                component.span());
    }
}
