package arcomat.generate;

import arcomat.generate.language.TypeName;
import arcomat.generate.view.FieldView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.MonitorView;
import arcomat.generate.view.MonitorView.EventsView;
import arcomat.generate.view.MonitorView.SeenView;
import arcomat.generate.view.MonitorView.SpeltView;
import arcomat.generate.view.TypeView;
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
        Fields fields = new Fields(watched, context);
        List<FieldView> constants = watched.constants().stream().map(fields::declared).toList();
        List<FieldView> variables = automaton.variables().stream().map(fields::of).toList();
        ExpressionText text = context.expressions();
        List<SeenView> outputs = watched.outputs().stream().map(this::seen).toList();
        String requirement =
                watched.title(automaton) + " (line " + Places.line(automaton.span()) + ")";
        List<MonitorView.GoView> initials = steps.initials();
        List<MonitorView.SectionView> sections = steps.sections();
        List<EventsView> events =
                watched.profile() == Component.Profile.EVENT_DRIVEN ? List.of(events()) : List.of();
        List<String> imports = imports(head); // known only after everything is written
        return new MonitorView(
                head,
                imports,
                watched.title(automaton),
                text.literal(requirement),
                constants,
                fields.constructed(),
                steps.named() ? fields.states(automaton) : List.of(),
                automaton.states().size() <= MOST_STATE_NAMES
                        ? automaton.states().stream().map(text::literal).toList()
                        : List.of(),
                outputs,
                variables,
                initials,
                sections,
                steps.completion(),
                context.members().state(),
                spelt(),
                events);
    }

    private EventsView events() {
        ExpressionText text = context.expressions();
        Formula present =
                new Formula.Or(
                        watched.inputs().stream()
                                .filter(port -> !port.latched())
                                .map(port -> (Formula) new Formula.Carries(port, true))
                                .toList());
        return new EventsView(text.text(present).text());
    }

    /** Whole numbers, strings and objects are told by the runtime. */
    private List<SpeltView> spelt() {
        List<SpeltView> spelt = new ArrayList<>();
        for (int port = 0; port < watched.outputs().size(); port++) {
            Type type = watched.outputs().get(port).type();
            if (!(type instanceof Type.IntegerType
                    || type instanceof Type.StringType
                    || type instanceof Type.ClassType)) {
                spelt.add(new SpeltView(port, context.expressions().spelt("message", type)));
            }
        }
        return spelt;
    }

    private SeenView seen(Port port) {
        ExpressionText text = context.expressions();
        return new SeenView(
                text.literal(port.name()),
                port.delay() > 0,
                mayShowNothing(port) ? text.presence(port, true).text() : "",
                text.code(port));
    }

    /** Whoever sets a total port to the code of no message is heard, too. */
    private boolean mayShowNothing(Port port) {
        return port.type() instanceof Type.EnumType || context.expressions().mayBeAbsent(port);
    }

    /** Codes of enums, and the enums themselves where they are sent. */
    private List<String> imports(HeadView head) {
        Set<String> sent = new TreeSet<>();
        for (Port port : watched.outputs()) {
            if (port.type() instanceof Type.EnumType) {
                sent.add(context.names().of(port.type()).qualified());
            }
        }
        Set<String> imports = new TreeSet<>();
        if (context.expressions().checks()) {
            imports.add(CHECK);
        }
        for (TypeView type : head.mentions()) {
            TypeName name = new TypeName(type.packageName(), type.name());
            boolean foreign = !type.neighbour() && !type.packageName().isEmpty();
            if (type.kind().equals("enum")) {
                imports.add(name.qualified() + "Code");
            }
            if (foreign && (!type.kind().equals("enum") || sent.contains(name.qualified()))) {
                imports.add(name.qualified());
            }
        }
        return List.copyOf(imports);
    }
}
