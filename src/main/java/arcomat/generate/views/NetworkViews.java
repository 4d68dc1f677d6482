package arcomat.generate.views;

import arcomat.generate.language.NameForms;
import arcomat.generate.language.TypeName;
import arcomat.generate.plan.Arrangement;
import arcomat.generate.plan.Program;
import arcomat.generate.plan.Sections;
import arcomat.generate.plan.Sections.Section;
import arcomat.generate.text.FileContext;
import arcomat.generate.view.CompositeView.PartView;
import arcomat.generate.view.EventView.EventPortView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.NetworkView;
import arcomat.generate.view.NetworkView.MemberView;
import arcomat.generate.view.NetworkView.RouteView;
import arcomat.generate.view.NetworkView.ShareView;
import arcomat.generate.view.SubnetworkView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.network.Composition;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The views of an event-driven composite. A message is delivered when it is sent: the class that
 * holds a part overrides its sending methods by calls of the methods that take the message, so that
 * queues fill in the order that {@code semantics.Network} describes.
 */
public final class NetworkViews {
    private static final String SELF = "this";

    private final FileContext context;
    private final Program program;
    private final HeadView head;
    private final List<Composition.Node> nodes;
    private final Sections sections;
    private final String whole;
    private final Receivers receivers;

    public NetworkViews(FileContext context, Program program, HeadView head) {
        this.context = context;
        this.program = program;
        this.head = head;
        this.nodes = context.composition().map(Composition::nodes).orElse(List.of());
        this.sections =
                context.composition()
                        .map(inside -> program.arrangement(context).sections())
                        .orElse(Sections.NONE);
        this.whole = context.members().local("whole");
        this.receivers = new Receivers(context, program, whole);
    }

    /** Members of a class: parts or sections. */
    private final class Content {
        final List<MemberView> members = new ArrayList<>();
        final List<ShareView> shares = new ArrayList<>();
        final @Nullable Section here;
        boolean checks;

        Content(@Nullable Section here) {
            this.here = here;
        }

        void addNodes(int first, int end) {
            for (int i = first; i < end; i++) {
                Composition.Node node = nodes.get(i);
                checks |= Arrangement.checks(node);
                members.add(
                        new MemberView(
                                CompositeViews.part(context, program, node),
                                !node.component().platform(),
                                routes(i, node.component())));
            }
        }

        private List<RouteView> routes(int sender, Component component) {
            return routes(
                            sender,
                            component.outputs(),
                            EventViews.ports(
                                    program.context(component),
                                    component.outputs(),
                                    Heads.of(component, program).outputs()))
                    .stream()
                    .filter(route -> !route.calls().isEmpty())
                    .toList();
        }

        /**
         * @param sender position of the part, {@link Receivers#OUTSIDE} for inputs of the whole
         */
        List<RouteView> routes(int sender, List<Port> ports, List<EventPortView> views) {
            return IntStream.range(0, ports.size())
                    .mapToObj(i -> route(sender, ports.get(i), views.get(i)))
                    .toList();
        }

        private RouteView route(int sender, Port port, EventPortView view) {
            List<String> calls = receivers.of(sender, port, here);
            List<ShareView> some = shares(calls, view.port().type());
            shares.addAll(some);
            return new RouteView(
                    view, some.isEmpty() ? calls : some.stream().map(ShareView::method).toList());
        }

        void addSections(List<Section> inner, String self) {
            for (Section section : inner) {
                String arguments =
                        CompositeViews.argumentsOfSection(self, head, Arrangement.choice(context));
                String type = type(section).name();
                members.add(
                        new MemberView(
                                PartView.single(type, section.field(), arguments, ""),
                                true,
                                List.of()));
            }
        }
    }

    /** Calls that are too many for one method, by the methods that share them; else none. */
    private List<ShareView> shares(List<String> calls, String type) {
        List<ShareView> shares = new ArrayList<>();
        for (int i = 0; calls.size() > MethodSize.MOST_CALLS && i < calls.size(); ) {
            int end = Math.min(calls.size(), i + MethodSize.MOST_CALLS);
            String method = context.members().claim("share");
            shares.add(new ShareView(method, type, calls.subList(i, end)));
            i = end;
        }
        return shares;
    }

    /** A composite; a platform component is one without members. */
    public NetworkView view() {
        Content content = new Content(null);
        if (sections.top().isEmpty()) {
            content.addNodes(0, nodes.size());
        } else {
            content.addSections(sections.top(), SELF);
        }
        List<Port> inputs = context.component().inputs();
        List<RouteView> routes =
                content.routes(
                        Receivers.OUTSIDE,
                        inputs,
                        EventViews.ports(context, inputs, head.inputs()));
        return new NetworkView(
                head,
                content.members,
                routes,
                EventViews.ports(context, context.component().outputs(), head.outputs()),
                content.shares,
                context.members().local("border"),
                content.checks);
    }

    /** The classes of the sections, none for a composite of usual size. */
    public List<SubnetworkView> sections() {
        return sections.all().stream().map(this::view).toList();
    }

    private SubnetworkView view(Section section) {
        Content content = new Content(section);
        if (section.inner().isEmpty()) {
            content.addNodes(section.first(), section.end());
        } else {
            content.addSections(section.inner(), whole);
        }
        return new SubnetworkView(
                head, type(section), content.members, content.shares, whole, content.checks);
    }

    private TypeName type(Section section) {
        return context.names().beside(context.component(), NameForms.capitalised(section.field()));
    }
}
