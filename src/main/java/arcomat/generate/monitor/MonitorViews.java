package arcomat.generate.monitor;

import arcomat.generate.language.Places;
import arcomat.generate.language.Text;
import arcomat.generate.language.TypeName;
import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.Formula;
import arcomat.generate.text.RuntimeChecks;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.HeadView.TypeView;
import arcomat.generate.view.MonitorView;
import arcomat.generate.view.MonitorView.EventsView;
import arcomat.generate.view.MonitorView.SeenView;
import arcomat.generate.view.MonitorView.SpeltView;
import arcomat.generate.views.AtomicViews;
import arcomat.generate.views.Declarations;
import arcomat.generate.views.Heads;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Type;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** The view of a class that watches a component for one requirement. */
final class MonitorViews {
    /** The runtime's operations that look out for what may go wrong. */
    private static final String CHECK = "arcomat.rt.Check";

    /** More names would not fit into one constructor. */
    private static final int MOST_STATE_NAMES = 2000;

    /** Kinds of messages for which a target has nothing to say: the runtime tells them. */
    private static final Set<String> TOLD_BY_RUNTIME =
            Set.of("byte", "short", "int", "long", "string", "class", "java");

    private final Component watched;
    private final Automaton automaton;
    private final FileContext context;
    private final MonitorSteps steps;

    /**
     * @param watched the component of the model
     * @param context of the class to be written
     */
    MonitorViews(Component watched, Automaton automaton, FileContext context) {
        this.watched = watched;
        this.automaton = automaton;
        this.context = context;
        this.steps = new MonitorSteps(watched, automaton, context);
    }

    MonitorView view() {
        HeadView head = Heads.of(context, false);
        Declarations declarations = new Declarations(watched, context);
        ExpressionWriter text = context.expressions();
        String requirement =
                watched.title(automaton) + " (line " + Places.line(automaton.span()) + ")";
        List<String> states = automaton.states();
        return new MonitorView(
                head,
                imports(head),
                watched.title(automaton),
                text.literal(requirement),
                declarations.declared(watched.constants()),
                declarations.constructed(watched.constants()),
                AtomicViews.hasNamedStates(automaton) ? declarations.states(automaton) : List.of(),
                states.size() <= MOST_STATE_NAMES
                        ? states.stream().map(text::literal).toList()
                        : List.of(),
                watched.outputs().stream().map(this::seen).toList(),
                automaton.variables().stream().map(declarations::of).toList(),
                steps.initials(),
                steps.sections(),
                steps.completion(),
                context.members().state(),
                spelt(),
                context.isEventDriven() ? List.of(events()) : List.of());
    }

    private EventsView events() {
        List<Formula> present =
                watched.inputs().stream()
                        .filter(port -> !port.latched())
                        .map(port -> (Formula) new Formula.Carries(port, true))
                        .toList();
        return new EventsView(context.expressions().of(new Formula.Row(false, present)).text());
    }

    private List<SpeltView> spelt() {
        Text code = Text.primary("message");
        List<SpeltView> spelt = new ArrayList<>();
        for (int port = 0; port < watched.outputs().size(); port++) {
            Type type = watched.outputs().get(port).type();
            if (!TOLD_BY_RUNTIME.contains(context.names().language().kind(type))) {
                String text = context.expressions().express("spelt", type, code).text();
                spelt.add(new SpeltView(port, text));
            }
        }
        return spelt;
    }

    /** Whoever sets a total enum port to the code of no message is heard, too. */
    private SeenView seen(Port port) {
        ExpressionWriter text = context.expressions();
        boolean silent = port.type() instanceof Type.EnumType || text.mayBeAbsent(port);
        return new SeenView(
                text.literal(port.name()),
                port.delay() > 0,
                silent ? text.of(new Formula.Carries(port, true)).text() : "",
                text.express("code", port.type(), text.of(port)).text());
    }

    /** Codes of enums, and the enums themselves where they are sent. */
    private List<String> imports(HeadView head) {
        Set<TypeName> sent =
                context.names().ofEnums(watched.outputs().stream().map(Port::type).toList());
        Set<String> imports = new TreeSet<>();
        if (RuntimeChecks.atBeginning(watched, automaton)) {
            imports.add(CHECK);
        }
        for (TypeView type : head.mentions()) {
            TypeName name = type.self();
            boolean foreign = !type.neighbour() && !name.packageName().isEmpty();
            boolean code = type.kind().equals("enum");
            if (code) {
                imports.add(name.qualified() + "Code");
            }
            if (foreign && (!code || sent.contains(name))) {
                imports.add(name.qualified());
            }
        }
        return List.copyOf(imports);
    }
}
