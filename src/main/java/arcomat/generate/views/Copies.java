package arcomat.generate.views;

import arcomat.generate.plan.Arrangement;
import arcomat.generate.plan.Draft.Stretch;
import arcomat.generate.plan.Program;
import arcomat.generate.plan.Regularity;
import arcomat.generate.plan.Sections;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Objects;

/** The copies that carry messages from sender to receiver within one composite. */
final class Copies {
    private final FileContext context;
    private final Arrangement arrangement;
    private final Composition composition;
    private final Program program;
    private final String whole;

    /**
     * @param whole the field by which a section knows the composite
     */
    Copies(FileContext context, Program program, String whole) {
        this.context = context;
        this.arrangement = program.arrangement(context);
        this.composition = arrangement.composition();
        this.program = program;
        this.whole = whole;
    }

    /** One end of a copy: the object, as the class that holds the copy names it, and the port. */
    private record End(String object, Component component, Port port) {}

    /**
     * What carries a message.
     *
     * @param moves copies of the message, and of whether there is one
     * @param fixed presence flags that never change
     */
    record Copy(List<AssignmentView> moves, List<AssignmentView> fixed) {
        private static final Copy NONE = new Copy(List.of(), List.of());
    }

    /** To an input of a node, as seen from where the node is. */
    Copy toNode(int node, int input) {
        Composition.Node receiver = composition.nodes().get(node);
        Port port = receiver.component().inputs().get(input);
        return copy(
                receiver.inputs().get(input),
                arrangement.sections().of(node),
                new End(arrangement.object(node), receiver.component(), port));
    }

    /** To an input of the nodes of a run, by an index into their array. */
    Copy toRun(Regularity.Run run, int input, String index, LoopLocals locals) {
        Composition.Node node = composition.nodes().get(run.first());
        Source source = node.inputs().get(input);
        Sections.Section here = arrangement.sections().of(run.first());
        Stretch receivers = Objects.requireNonNull(arrangement.holder(run.first()));
        Port port = node.component().inputs().get(input);
        String place = arrangement.element(receivers, index);
        End receiver = new End(locals.receiver(node.component(), place), node.component(), port);
        int stride = run.strides()[input];
        if (stride == 0) {
            return copy(source, here, receiver);
        }
        Source.FromNode from = (Source.FromNode) source;
        Stretch senders = Objects.requireNonNull(arrangement.holder(from.node()));
        int start = from.node() - senders.first() - stride * (run.first() - receivers.first());
        String element = arrangement.element(senders, linear(stride, index, start));
        Component sending = composition.nodes().get(from.node()).component();
        String leading = arrangement.leading(from.node(), here, whole);
        String object = locals.sender(sending, leading + element);
        return copy(sender(from, object), receiver);
    }

    /** {@code i + 1}, {@code 9 - i}, {@code 2 * i - 1}. */
    private static String linear(int stride, String index, int start) {
        if (stride == -1) {
            return start + " - " + index;
        }
        String product = stride == 1 ? index : stride + " * " + index;
        return start == 0 ? product : product + (start < 0 ? " - " : " + ") + Math.abs(start);
    }

    /** To an output of the composite itself. */
    Copy toOutside(Composition.Output output) {
        return copy(output.source(), null, new End("", composition.component(), output.port()));
    }

    private Copy copy(Source source, Sections.@Nullable Section here, End receiver) {
        return source.match(
                outside -> {
                    String object = here == null ? "" : whole;
                    return copy(new End(object, composition.component(), outside.port()), receiver);
                },
                from -> {
                    String object = arrangement.object(from.node(), here, whole);
                    return copy(sender(from, object), receiver);
                },
                () -> Copy.NONE);
    }

    private End sender(Source.FromNode from, String object) {
        return new End(object, composition.nodes().get(from.node()).component(), from.port());
    }

    private Copy copy(End sender, End receiver) {
        MemberNames from = program.members(sender.component);
        MemberNames to = program.members(receiver.component);
        AssignmentView message =
                new AssignmentView(
                        field(receiver, to.of(receiver.port)), field(sender, from.of(sender.port)));
        String flag = to.flag(receiver.port);
        if (flag.isEmpty()) {
            return new Copy(List.of(message), List.of());
        }
        String sent = from.flag(sender.port);
        String present = sent.isEmpty() ? context.expressions().truth(true) : field(sender, sent);
        AssignmentView presence = new AssignmentView(field(receiver, flag), present);
        return sent.isEmpty()
                ? new Copy(List.of(message), List.of(presence))
                : new Copy(List.of(message, presence), List.of());
    }

    private String field(End end, String member) {
        return context.expressions().member(end.object, member);
    }
}
