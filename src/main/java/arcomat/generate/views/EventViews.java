package arcomat.generate.views;

import arcomat.generate.plan.AutomatonPlan;
import arcomat.generate.plan.Program;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.EventView;
import arcomat.generate.view.EventView.EventPortView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.HeadView.PortView;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.List;

/** The views of event-driven components with an automaton, and of the ports of all. */
public final class EventViews {
    private final FileContext context;
    private final Program program;
    private final HeadView head;

    public EventViews(FileContext context, Program program, HeadView head) {
        this.context = context;
        this.program = program;
        this.head = head;
    }

    public EventView view(AutomatonPlan plan) {
        MemberNames members = context.members();
        return new EventView(
                head,
                new AtomicViews(context, plan, program.traced()).view(head),
                ports(context, context.component().inputs(), head.inputs()),
                ports(context, context.component().outputs(), head.outputs()),
                context.component().queueCapacity(),
                members.local("waiting"),
                members.local("oldest"),
                members.local("queued"),
                members.local("border"));
    }

    static List<EventPortView> ports(FileContext context, List<Port> ports, List<PortView> heads) {
        List<EventPortView> views = new ArrayList<>();
        for (Port port : ports) {
            int number = views.size();
            boolean waits = port.isInput() && !port.latched();
            views.add(
                    new EventPortView(
                            heads.get(number),
                            context.members().method(port),
                            port.first()
                                    .map(v -> context.expressions().of(v, port.type()).text())
                                    .orElse(""),
                            waits ? context.members().local("waiting", port.name()) : "",
                            port.latched(),
                            number,
                            context.expressions().literal(port.name())));
        }
        return views;
    }
}
