package arcomat.generate;

import arcomat.generate.view.AssignmentView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.Composition;
import arcomat.semantics.Source;

import java.util.List;

/** The copies that carry messages from sender to receiver within one composite. */
final class Copies {
    private final FileContext context;
    private final Composition composition;
    private final Program program;
    private final Sections sections;
    private final String whole;

    /**
     * @param whole the field by which a section knows the composite
     */
    Copies(FileContext context, Program program, Sections sections, String whole) {
        this.context = context;
        this.composition = context.composition().orElseThrow();
        this.program = program;
        this.sections = sections;
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
        Sections.Section here = sections.of(node);
        Composition.Node receiver = composition.nodes().get(node);
        String object = context.members().part(receiver.path());
        copy(sender(source, here), new End(object, receiver.component(), port), copies, fixed);
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
            Composition.Node node = composition.nodes().get(from.node());
            String field = context.members().part(node.path());
            return new End(object(from.node(), field, here), node.component(), from.port());
        }
        Port port = ((Source.FromOutside) source).port();
        return new End(here == null ? "" : whole, composition.component(), port);
    }

    private String object(int node, String field, Sections.Section here) {
        Sections.Section there = sections.of(node);
        if (there == null || there == here) {
            return field;
        }
        return (here == null ? "" : whole + ".") + there.path() + "." + field;
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
