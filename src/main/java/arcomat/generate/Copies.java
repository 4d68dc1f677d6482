package arcomat.generate;

import arcomat.generate.view.AssignmentView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.List;

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
     * To an input of a node, as seen from where the node is.
     *
     * @param fixed gets presence flags that never change
     */
    void toNode(
            Source source,
            int node,
            Port port,
            List<AssignmentView> copies,
            List<AssignmentView> fixed) {
        if (source instanceof Source.Unconnected) {
            return;
        }
        Sections.Section here = arrangement.sections().of(node);
        Composition.Node receiver = composition.nodes().get(node);
        copy(
                sender(source, here),
                new End(arrangement.object(node), receiver.component(), port),
                copies,
                fixed);
    }

    /**
     * To an input of the nodes of a run, by an index into their array.
     *
     * @param fixed gets presence flags that never change
     */
    void toRun(
            Regularity.Run run,
            int input,
            String index,
            List<AssignmentView> copies,
            List<AssignmentView> fixed) {
        Composition.Node node = composition.nodes().get(run.first());
        Source source = node.inputs().get(input);
        Sections.Section here = arrangement.sections().of(run.first());
        Stretch receivers = arrangement.holder(run.first());
        End sender = sender(source, here);
        if (run.strides()[input] != 0) {
            int first = ((Source.FromNode) source).node();
            Stretch senders = arrangement.holder(first);
            int stride = run.strides()[input];
            int start = first - senders.first() - stride * (run.first() - receivers.first());
            String object = arrangement.element(senders, linear(stride, index, start));
            sender = new End(leading(first, here) + object, sender.component, sender.port);
        }
        Port port = node.component().inputs().get(input);
        End receiver = new End(arrangement.element(receivers, index), node.component(), port);
        copy(sender, receiver, copies, fixed);
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
    void toOutside(
            Composition.Output output, List<AssignmentView> copies, List<AssignmentView> fixed) {
        if (!(output.source() instanceof Source.Unconnected)) {
            End receiver = new End("", composition.component(), output.port());
            copy(sender(output.source(), null), receiver, copies, fixed);
        }
    }

    private End sender(Source source, Sections.Section here) {
        if (source instanceof Source.FromNode from) {
            String object = leading(from.node(), here) + arrangement.object(from.node());
            Component component = composition.nodes().get(from.node()).component();
            return new End(object, component, from.port());
        }
        Port port = ((Source.FromOutside) source).port();
        return new End(here == null ? "" : whole, composition.component(), port);
    }

    /** From one section to the place of a node. */
    private String leading(int node, Sections.Section here) {
        Sections.Section there = arrangement.sections().of(node);
        if (there == null || there == here) {
            return "";
        }
        return (here == null ? "" : whole + ".") + there.path() + ".";
    }

    private void copy(
            End sender, End receiver, List<AssignmentView> copies, List<AssignmentView> fixed) {
        Members from = program.members(sender.component);
        Members to = program.members(receiver.component);
        copies.add(
                new AssignmentView(
                        field(receiver, to.of(receiver.port)),
                        field(sender, from.of(sender.port))));
        String flag = to.flag(receiver.port);
        if (flag.isEmpty()) {
            return;
        }
        String sent = from.flag(sender.port);
        if (sent.isEmpty()) {
            fixed.add(new AssignmentView(field(receiver, flag), context.expressions().truth(true)));
        } else {
            copies.add(new AssignmentView(field(receiver, flag), field(sender, sent)));
        }
    }

    private String field(End end, String member) {
        return context.expressions().member(end.object, member);
    }
}
