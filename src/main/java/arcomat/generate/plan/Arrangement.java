package arcomat.generate.plan;

import arcomat.generate.language.NameForms;
import arcomat.generate.plan.Draft.Stretch;
import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.RuntimeChecks;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.network.Composition;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * How the parts of a composite are ordered and held. Usually each is a field, in the order of the
 * schedule. Where many are of one component, they share arrays and are served by loops: code for
 * each of them would be more than a processor keeps at hand. A target asks for that by the entry
 * {@code element}, and for sections of event-driven parts by the entry {@code networks}.
 *
 * <p>Parts that neither draw nor fail may then leave the schedule's order, which nobody can
 * observe, for one that needs less code.
 */
public final class Arrangement {
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
            Arrays.fill(holders, stretch.first(), stretch.end(), stretch.called(field));
        }
    }

    static Arrangement of(FileContext context, Program program) {
        Composition schedule = context.composition().orElseThrow();
        if (context.isEventDriven()) {
            return new Arrangement(context, plain(schedule), sections(context, schedule));
        }
        Draft best = isRepetitive(context) ? best(context, program) : plain(schedule);
        Draft draft = best.stretches().isEmpty() ? plain(schedule) : best;
        return new Arrangement(context, draft, Sections.of(draft.units(), context.members()));
    }

    /** Of event-driven parts, where a target asks for that. */
    private static Sections sections(FileContext context, Composition schedule) {
        if (context.names().language().entry("networks").isEmpty()) {
            return Sections.NONE;
        }
        return Sections.of(
                IntStream.range(0, schedule.nodes().size())
                        .mapToObj(node -> new Sections.Unit(node, node + 1, 0))
                        .toList(),
                context.members());
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
        return Draft.of(schedule, node -> false, node -> false);
    }

    private static Draft best(FileContext context, Program program) {
        Composition schedule = context.composition().orElseThrow();
        List<Draft> drafts = new ArrayList<>();
        if (schedule.nodes().stream().allMatch(node -> isUnobservable(node, program))) {
            Stream.of(true, false)
                    .map(deepFirst -> Reordering.of(schedule, deepFirst))
                    .forEach(order -> drafts.add(draft(order, context, program)));
        }
        drafts.add(draft(schedule, context, program));
        return drafts.stream().min(Comparator.comparingLong(Draft::cost)).orElseThrow();
    }

    /** Whether nobody can tell when a part is constructed and takes its steps. */
    private static boolean isUnobservable(Composition.Node node, Program program) {
        Component component = node.component();
        return !component.platform()
                && !program.draws(component)
                && !program.fails(component)
                && !checks(node);
    }

    private static Draft draft(Composition order, FileContext context, Program program) {
        List<Composition.Node> nodes = order.nodes();
        List<String> arguments =
                nodes.stream().map(node -> arguments(node, context, program)).toList();
        return Draft.of(
                order,
                node -> mayShare(nodes.get(node).component(), program),
                node -> arguments.get(node).equals(arguments.get(node - 1)));
    }

    /** What the constructor of a node is called with. */
    public static String arguments(Composition.Node node, FileContext context, Program program) {
        List<String> arguments = new ArrayList<>();
        if (program.draws(node.component())) {
            arguments.add(choice(context));
        }
        ExpressionWriter text =
                context.expressions().at(Fault.place(context.component(), node.path()));
        List<Parameter> parameters = node.component().parameters();
        for (int i = 0; i < parameters.size(); i++) {
            Parameter parameter = parameters.get(i);
            Expression argument = node.arguments().get(i);
            arguments.add(text.inRange(argument, parameter.type(), parameter.name()).text());
        }
        return String.join(", ", arguments);
    }

    /** Whether computing the arguments of a node may go wrong. */
    public static boolean checks(Composition.Node node) {
        List<Parameter> parameters = node.component().parameters();
        return IntStream.range(0, parameters.size())
                .anyMatch(
                        i ->
                                RuntimeChecks.ANYWHERE.areNeeded(
                                        node.arguments().get(i), parameters.get(i).type()));
    }

    /** The generator of choices. */
    public static String choice(FileContext context) {
        return context.names().language().entry("choice").orElse("choice");
    }

    /** Sensors and what contains them are few, and have names that people look for. */
    private static boolean mayShare(Component component, Program program) {
        return !component.platform() && !program.senses(component);
    }

    private static String plural(Component component) {
        return NameForms.uncapitalised(NameForms.type(component.name())) + "s";
    }

    public Composition composition() {
        return draft.composition();
    }

    public Draft draft() {
        return draft;
    }

    public Sections sections() {
        return sections;
    }

    /** The array that holds a node; null where it has a field of its own. */
    public @Nullable Stretch holder(int node) {
        return holders[node];
    }

    /** A node as an object of the class that holds it. */
    public String object(int node) {
        Stretch holder = holders[node];
        return holder == null
                ? context.members().part(composition().nodes().get(node))
                : element(holder, "" + (node - holder.first()));
    }

    /**
     * What leads from one section to a node.
     *
     * @param here null in the class of the composite
     * @param whole the field by which a section knows the composite
     */
    public String object(int node, Sections.@Nullable Section here, String whole) {
        return leading(node, here, whole) + object(node);
    }

    /** The same up to the class that holds the node; with a dot at its end where it is another. */
    public String leading(int node, Sections.@Nullable Section here, String whole) {
        Sections.Section there = sections.of(node);
        if (there == null || there == here) {
            return "";
        }
        return (here == null ? "" : whole + ".") + there.path() + ".";
    }

    public String element(Stretch stretch, String index) {
        return context.names()
                .language()
                .spell("element", Map.of("part", stretch.field(), "index", index));
    }

    /** The fields that lead from the composite to each node, by the path of the node. */
    public Map<String, String> paths() {
        Map<String, String> paths = new LinkedHashMap<>();
        for (int node = 0; node < holders.length; node++) {
            paths.put(composition().nodes().get(node).path(), object(node, null, ""));
        }
        return paths;
    }
}
