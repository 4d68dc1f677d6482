package arcomat.generate;

import arcomat.generate.language.TypeName;
import arcomat.generate.language.Words;
import arcomat.generate.view.AssignmentView;
import arcomat.generate.view.CompositeView;
import arcomat.generate.view.FieldView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.LoopsView;
import arcomat.generate.view.PartView;
import arcomat.generate.view.PartsView;
import arcomat.generate.view.StepView;
import arcomat.model.Port;
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
final class CompositeViews {
    private final FileContext context;
    private final Arrangement arrangement;
    private final Composition composition;
    private final Program program;
    private final Sections sections;
    private final Copies copies;
    private final String whole;

    CompositeViews(FileContext context, Program program) {
        this.context = context;
        this.arrangement = program.arrangement(context);
        this.composition = arrangement.composition();
        this.program = program;
        this.sections = arrangement.sections();
        this.whole = context.members().local("whole", "");
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
        final ArrayContent arrays = new ArrayContent(context, arrangement, copies);

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
        }

        LoopsView loops() {
            return new LoopsView(arrays.fixed(), arrays.known(), arrays.reordered());
        }

        private void addNode(int index, List<StepView> steps) {
            Composition.Node node = composition.nodes().get(index);
            String field = context.members().part(node.path());
            members.add(part(context, program, node, field));
            if (program.senses(node.component())) {
                sensors.add(field);
            }
            List<AssignmentView> fresh = new ArrayList<>();
            for (int i = 0; i < node.inputs().size(); i++) {
                Source source = node.inputs().get(i);
                Port port = node.component().inputs().get(i);
                copies.toNode(source, index, port, isFresh(source) ? fresh : known, fixed);
            }
            String call = program.call(node.component());
            if (!call.isEmpty() || !fresh.isEmpty()) {
                steps.add(StepView.once(field, call, fresh));
            }
        }

        void addSections(List<Sections.Section> inner, HeadView head, String self) {
            for (Sections.Section section : inner) {
                List<String> arguments = new ArrayList<>(List.of(self));
                if (head.draws()) {
                    arguments.add(Arrangement.choice(context));
                }
                head.parameters().stream().map(FieldView::name).forEach(arguments::add);
                members.add(
                        PartView.single(
                                type(section).name(),
                                section.field(),
                                String.join(", ", arguments),
                                ""));
                if (senses(section)) {
                    sensors.add(section.field());
                }
                knowers.add(section.field());
                steps.add(StepView.once(section.field(), "step", List.of()));
            }
        }
    }

    CompositeView view(HeadView head) {
        Content content = new Content();
        if (sections.top().isEmpty()) {
            content.addNodes(0, composition.nodes().size());
        } else {
            content.addSections(sections.top(), head, "this");
        }
        List<AssignmentView> sensed = new ArrayList<>();
        List<AssignmentView> registers = new ArrayList<>();
        List<AssignmentView> fresh = new ArrayList<>();
        for (Composition.Output output : composition.outputs()) {
            List<AssignmentView> place = place(output.source(), sensed, registers, fresh);
            copies.toOutside(output, place, content.fixed);
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
                content.loops(),
                context.expressions().checks());
    }

    /** The classes of the sections, none for a composite of usual size. */
    List<PartsView> sections(HeadView head) {
        return sections.all().stream().map(section -> view(section, head)).toList();
    }

    private PartsView view(Sections.Section section, HeadView head) {
        Content content = new Content();
        if (section.inner().isEmpty()) {
            content.addNodes(section.first(), section.end());
        } else {
            content.addSections(section.inner(), head, whole);
        }
        TypeName type = type(section);
        return new PartsView(
                head,
                type.packageName(),
                type.prefix(),
                type.folder(),
                type.name(),
                content.members,
                content.fixed,
                content.sensors,
                content.knowers,
                content.known,
                content.steps,
                whole,
                content.loops(),
                context.expressions().checks());
    }

    private TypeName type(Sections.Section section) {
        String suffix = Words.capitalised(section.field());
        return context.names().beside(context.component(), suffix);
    }

    private boolean senses(Sections.Section section) {
        return composition.nodes().subList(section.first(), section.end()).stream()
                .anyMatch(node -> program.senses(node.component()));
    }

    private List<AssignmentView> place(
            Source source,
            List<AssignmentView> sensed,
            List<AssignmentView> registers,
            List<AssignmentView> fresh) {
        if (!(source instanceof Source.FromNode from) || from.fresh()) {
            return fresh;
        }
        Composition.Node node = composition.nodes().get(from.node());
        return program.isSensed(node, from.port()) ? sensed : registers;
    }

    private static boolean isFresh(Source source) {
        return source instanceof Source.FromNode from && from.fresh();
    }

    static PartView part(
            FileContext context, Program program, Composition.Node node, String field) {
        return PartView.single(
                context.references().to(context.names().of(node.component())),
                field,
                Arrangement.arguments(node, context, program),
                node.path() + ": " + node.component().qualifiedName());
    }
}
