package arcomat.generate.views;

import arcomat.generate.language.NameForms;
import arcomat.generate.language.TypeName;
import arcomat.generate.plan.Arrangement;
import arcomat.generate.plan.Draft.Stretch;
import arcomat.generate.plan.Program;
import arcomat.generate.plan.Sections;
import arcomat.generate.text.FileContext;
import arcomat.generate.view.CompositeView;
import arcomat.generate.view.CompositeView.PartView;
import arcomat.generate.view.CompositeView.StepView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.HeadView.FieldView;
import arcomat.generate.view.PartsView;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.ArrayList;
import java.util.List;

/**
 * The views of a time-synchronous composite. Messages travel by copies between fields:
 *
 * <ul>
 *   <li>what is known when the slice starts (messages from outside, from sensors and from delayed
 *       outputs) is copied first, so that the field of a delayed output is its own register;
 *   <li>then the parts take their steps in the order of the schedule, each after it got the
 *       messages of the same slice;
 *   <li>at the end the composite's own outputs are copied, delayed ones for the next slice.
 * </ul>
 */
public final class CompositeViews {
    private final FileContext context;
    private final HeadView head;
    private final Arrangement arrangement;
    private final Composition composition;
    private final Program program;
    private final Sections sections;
    private final Copies copies;
    private final String whole;

    public CompositeViews(FileContext context, Program program, HeadView head) {
        this.context = context;
        this.head = head;
        this.arrangement = program.arrangement(context);
        this.composition = arrangement.composition();
        this.program = program;
        this.sections = arrangement.sections();
        this.whole = context.members().local("whole");
        this.copies = new Copies(context, program, whole);
    }

    /** Members of a class: parts or sections. */
    private final class Content {
        final List<PartView> members = new ArrayList<>();
        final List<AssignmentView> fixed = new ArrayList<>();
        final List<String> sensors = new ArrayList<>();
        final List<String> knowers = new ArrayList<>();
        final List<AssignmentView> known = new ArrayList<>();
        final List<StepView> steps = new ArrayList<>();
        final ArrayViews arrays = new ArrayViews(context, arrangement, copies);
        boolean checks;

        void addNodes(int first, int end) {
            List<StepView> actuators = new ArrayList<>();
            for (int i = first; i < end; ) {
                Stretch stretch = arrangement.holder(i);
                if (stretch == null) {
                    boolean acts = composition.nodes().get(i).component().platform();
                    addNode(i++, acts ? actuators : steps);
                } else {
                    members.add(arrays.member(stretch, program));
                    steps.addAll(arrays.steps(stretch));
                    arrays.know(stretch);
                    i = stretch.end();
                }
            }
            // Nobody waits for them, and what they show is settled: they come behind all logic.
            steps.addAll(actuators);
            checks = composition.nodes().subList(first, end).stream().anyMatch(Arrangement::checks);
        }

        private void addNode(int index, List<StepView> steps) {
            Composition.Node node = composition.nodes().get(index);
            PartView part = part(context, program, node);
            members.add(part);
            if (program.senses(node.component())) {
                sensors.add(part.name());
            }
            List<AssignmentView> fresh = new ArrayList<>();
            for (int i = 0; i < node.inputs().size(); i++) {
                boolean same = node.inputs().get(i) instanceof Source.FromNode from && from.fresh();
                add(copies.toNode(index, i), same ? fresh : known);
            }
            String call = program.call(node.component());
            if (!call.isEmpty() || !fresh.isEmpty()) {
                steps.add(StepView.once(part.name(), call, fresh));
            }
        }

        void add(Copies.Copy copy, List<AssignmentView> place) {
            place.addAll(copy.moves());
            fixed.addAll(copy.fixed());
        }

        void addSections(List<Sections.Section> inner, String self) {
            String arguments = argumentsOfSection(self, head, Arrangement.choice(context));
            for (Sections.Section section : inner) {
                String field = section.field();
                String type = type(section).name();
                members.add(PartView.single(type, field, arguments, ""));
                if (senses(section)) {
                    sensors.add(field);
                }
                knowers.add(field);
                steps.add(StepView.once(field, "step", List.of()));
            }
        }
    }

    public CompositeView view() {
        Content content = new Content();
        if (sections.top().isEmpty()) {
            content.addNodes(0, composition.nodes().size());
        } else {
            content.addSections(sections.top(), "this");
        }
        List<AssignmentView> sensed = new ArrayList<>();
        List<AssignmentView> registers = new ArrayList<>();
        List<AssignmentView> fresh = new ArrayList<>();
        for (Composition.Output output : composition.outputs()) {
            List<AssignmentView> place = fresh;
            if (output.source() instanceof Source.FromNode from && !from.fresh()) {
                Composition.Node node = composition.nodes().get(from.node());
                place = program.isSensed(node, from.port()) ? sensed : registers;
            }
            content.add(copies.toOutside(output), place);
        }
        return new CompositeView(
                head,
                content.members,
                content.fixed,
                content.sensors,
                content.knowers,
                sensed,
                content.known,
                content.steps,
                registers,
                fresh,
                content.arrays.loops(),
                content.checks);
    }

    /** The classes of the sections, none for a composite of usual size. */
    public List<PartsView> sections() {
        return sections.all().stream().map(this::view).toList();
    }

    private PartsView view(Sections.Section section) {
        Content content = new Content();
        if (section.inner().isEmpty()) {
            content.addNodes(section.first(), section.end());
        } else {
            content.addSections(section.inner(), whole);
        }
        return new PartsView(
                head,
                type(section),
                content.members,
                content.fixed,
                content.sensors,
                content.knowers,
                content.known,
                content.steps,
                whole,
                content.arrays.loops(),
                content.checks);
    }

    private TypeName type(Sections.Section section) {
        String suffix = NameForms.capitalised(section.field());
        return context.names().beside(context.component(), suffix);
    }

    private boolean senses(Sections.Section section) {
        return composition.nodes().subList(section.first(), section.end()).stream()
                .anyMatch(node -> program.senses(node.component()));
    }

    /**
     * What the constructor of a section is called with.
     *
     * @param self the composite
     * @param choice the generator of choices
     */
    static String argumentsOfSection(String self, HeadView head, String choice) {
        List<String> arguments = new ArrayList<>(List.of(self));
        if (head.draws()) {
            arguments.add(choice);
        }
        head.parameters().stream().map(FieldView::name).forEach(arguments::add);
        return String.join(", ", arguments);
    }

    static PartView part(FileContext context, Program program, Composition.Node node) {
        return PartView.single(
                context.references().to(context.names().of(node.component())),
                context.members().part(node),
                Arrangement.arguments(node, context, program),
                node.path() + ": " + node.component().qualifiedName());
    }
}
