package arcomat.generate;

import arcomat.generate.language.TypeName;
import arcomat.generate.view.AssignmentView;
import arcomat.generate.view.CompositeView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.PartView;
import arcomat.generate.view.StepView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.Composition;
import arcomat.semantics.Source;

import java.util.ArrayList;
import java.util.List;

/**
 * The view of a time-synchronous composite. Messages travel by copies between fields:
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
    private final Composition composition;
    private final Program program;
    private final List<AssignmentView> fixed = new ArrayList<>();

    CompositeViews(FileContext context, Program program) {
        this.context = context;
        this.composition = context.composition().orElseThrow();
        this.program = program;
    }

    CompositeView view(HeadView head) {
        List<PartView> parts = new ArrayList<>();
        List<String> sensors = new ArrayList<>();
        List<AssignmentView> known = new ArrayList<>();
        List<StepView> steps = new ArrayList<>();
        for (Composition.Node node : composition.nodes()) {
            String field = context.members().part(node.path());
            parts.add(part(node, field));
            if (program.senses(node.component())) {
                sensors.add(field);
            }
            List<AssignmentView> fresh = new ArrayList<>();
            for (int i = 0; i < node.inputs().size(); i++) {
                Source source = node.inputs().get(i);
                Port port = node.component().inputs().get(i);
                copy(source, field, node.component(), port, isFresh(source) ? fresh : known);
            }
            String call = program.call(node.component());
            if (!call.isEmpty() || !fresh.isEmpty()) {
                steps.add(new StepView(field, call, fresh));
            }
        }
        List<AssignmentView> sensed = new ArrayList<>();
        List<AssignmentView> registers = new ArrayList<>();
        List<AssignmentView> fresh = new ArrayList<>();
        for (Composition.Output output : composition.outputs()) {
            copy(
                    output.source(),
                    "",
                    composition.component(),
                    output.port(),
                    place(output.source(), sensed, registers, fresh));
        }
        return new CompositeView(
                head,
                parts,
                fixed,
                sensors,
                sensed,
                known,
                steps,
                registers,
                fresh,
                context.expressions().checks());
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

    private PartView part(Composition.Node node, String field) {
        TypeName type = context.names().of(node.component());
        List<String> arguments = new ArrayList<>();
        if (program.draws(node.component())) {
            arguments.add(context.names().language().entry("choice").orElse("choice"));
        }
        node.arguments().forEach(a -> arguments.add(context.expressions().of(a).text()));
        return new PartView(
                context.references().to(type),
                field,
                String.join(", ", arguments),
                node.path() + ": " + node.component().qualifiedName());
    }

    /** Copies message and presence; a presence that never changes is set once and for all. */
    private void copy(
            Source source,
            String receiver,
            Component component,
            Port port,
            List<AssignmentView> copies) {
        if (source instanceof Source.Unconnected) {
            return;
        }
        String sender = "";
        Component sending = composition.component();
        Port from;
        if (source instanceof Source.FromNode node) {
            sender = context.members().part(composition.nodes().get(node.node()).path());
            sending = composition.nodes().get(node.node()).component();
            from = node.port();
        } else {
            from = ((Source.FromOutside) source).port();
        }
        Members senders = program.members(sending);
        Members receivers = program.members(component);
        copies.add(
                new AssignmentView(
                        field(receiver, receivers.of(port)), field(sender, senders.of(from))));
        String flag = receivers.flag(port);
        if (flag.isEmpty()) {
            return;
        }
        if (senders.flag(from).isEmpty()) {
            fixed.add(new AssignmentView(field(receiver, flag), context.expressions().truth(true)));
        } else {
            copies.add(
                    new AssignmentView(field(receiver, flag), field(sender, senders.flag(from))));
        }
    }

    private String field(String part, String member) {
        return context.expressions().member(part, member);
    }
}
