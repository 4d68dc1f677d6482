package arcomat.generate;

import arcomat.generate.language.Words;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.network.Composition;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * How the parts of a composite are ordered and held. Usually each is a field, in the order of the
 * schedule. Where many are of one component, they share arrays and are served by loops: code for
 * each of them would be more than a processor keeps at hand. A target asks for that by the entry
 * {@code element}.
 *
 * <p>Parts that neither draw nor fail may then leave the schedule's order, which nobody can
 * observe, for one that needs less code.
 */
final class Arrangement {
    private final FileContext context;
    private final Draft draft;
    private final Sections sections;
    private final Stretch[] holders;

    private Arrangement(FileContext context, Draft draft, Sections sections) {
        this.context = context;
        this.draft = draft;
        this.sections = sections;
        this.holders = new Stretch[draft.composition().nodes().size()];
        Map<String, Integer> used = new HashMap<>();
        for (Stretch stretch : draft.stretches()) {
            String name = plural(draft.composition().nodes().get(stretch.first()).component());
            int number = used.merge(name, 1, Integer::sum);
            String field = context.members().local(name, number == 1 ? "" : "" + number);
            Stretch named = new Stretch(field, stretch.first(), stretch.end(), stretch.merged());
            for (int node = named.first(); node < named.end(); node++) {
                holders[node] = named;
            }
        }
    }

    static Arrangement of(FileContext context, Program program) {
        Composition schedule = context.composition().orElseThrow();
        if (schedule.component().profile() == Component.Profile.EVENT_DRIVEN) {
            return new Arrangement(context, plain(schedule), new Sections(List.of(), null));
        }
        Draft best = isRepetitive(context) ? best(context, program) : plain(schedule);
        Draft draft = best.stretches().isEmpty() ? plain(schedule) : best;
        return new Arrangement(context, draft, new Sections(draft.units(), context.members()));
    }

    private static boolean isRepetitive(FileContext context) {
        if (context.names().language().entry("element").isEmpty()) {
            return false;
        }
        Map<String, Integer> counts = new HashMap<>();
        for (Composition.Node node : context.composition().orElseThrow().nodes()) {
            counts.merge(node.component().qualifiedName(), 1, Integer::sum);
        }
        return counts.values().stream().anyMatch(count -> count >= Stretch.LEAST);
    }

    private static Draft plain(Composition schedule) {
        return new Draft(schedule, node -> false, node -> false);
    }

    private static Draft best(FileContext context, Program program) {
        Composition schedule = context.composition().orElseThrow();
        List<Draft> drafts = new ArrayList<>();
        if (isUnobservable(schedule, context, program)) {
            Stream.of(true, false)
                    .map(deepFirst -> Reordering.of(schedule, deepFirst))
                    .forEach(order -> drafts.add(draft(order, context, program)));
        }
        drafts.add(draft(schedule, context, program));
        return drafts.stream().min(Comparator.comparingLong(Draft::cost)).orElseThrow();
    }

    private static Draft draft(Composition order, FileContext context, Program program) {
        List<Composition.Node> nodes = order.nodes();
        List<String> arguments =
                nodes.stream().map(node -> arguments(node, context, program)).toList();
        return new Draft(
                order,
                node -> mayShare(nodes.get(node).component(), program),
                node -> arguments.get(node).equals(arguments.get(node - 1)));
    }

    /** What the constructor of a node is called with. */
    static String arguments(Composition.Node node, FileContext context, Program program) {
        List<String> arguments = new ArrayList<>();
        if (program.draws(node.component())) {
            arguments.add(choice(context));
        }
        ExpressionText text = context.expressions();
        text.at(Fault.place(context.component(), node.path()));
        List<Parameter> parameters = node.component().parameters();
        for (int i = 0; i < parameters.size(); i++) {
            Parameter parameter = parameters.get(i);
            Expression argument = node.arguments().get(i);
            arguments.add(text.inRange(argument, parameter.type(), parameter.name()).text());
        }
        return String.join(", ", arguments);
    }

    /** The generator of choices. */
    static String choice(FileContext context) {
        return context.names().language().entry("choice").orElse("choice");
    }

    /** Sensors and what contains them are few, and have names that people look for. */
    private static boolean mayShare(Component component, Program program) {
        return !component.platform() && !program.senses(component);
    }

    /** Whether nobody can tell in which order the parts take their steps. */
    private static boolean isUnobservable(
            Composition schedule, FileContext context, Program program) {
        for (Composition.Node node : schedule.nodes()) {
            Component component = node.component();
            if (component.platform() || program.draws(component) || program.fails(component)) {
                return false;
            }
            arguments(node, context, program);
        }
        return !context.expressions().checks();
    }

    private static String plural(Component component) {
        return Words.uncapitalised(Words.type(component.name())) + "s";
    }

    Composition composition() {
        return draft.composition();
    }

    Draft draft() {
        return draft;
    }

    Sections sections() {
        return sections;
    }

    /** The array that holds a node; null where it has a field of its own. */
    Stretch holder(int node) {
        return holders[node];
    }

    /** A node as an object of the class that holds it. */
    String object(int node) {
        Stretch holder = holders[node];
        return holder == null
                ? context.members().part(composition().nodes().get(node).path())
                : element(holder, "" + (node - holder.first()));
    }

    String element(Stretch stretch, String index) {
        return context.names()
                .language()
                .spell("element", Map.of("part", stretch.field(), "index", index));
    }

    /** The fields that lead from the composite to a node. */
    String path(int node) {
        Sections.Section section = sections.of(node);
        String object = object(node);
        return section == null ? object : section.path() + "." + object;
    }
}
