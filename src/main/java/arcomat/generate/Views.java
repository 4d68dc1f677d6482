package arcomat.generate;

import arcomat.generate.OutputFiles.Kind;
import arcomat.generate.language.TypeName;
import arcomat.generate.monitor.SelfWatches;
import arcomat.generate.plan.AutomatonPlan;
import arcomat.generate.plan.Program;
import arcomat.generate.text.FileContext;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.PartsView;
import arcomat.generate.view.PlatformView;
import arcomat.generate.view.ProgramView;
import arcomat.generate.view.SubnetworkView;
import arcomat.generate.views.AtomicViews;
import arcomat.generate.views.CompositeViews;
import arcomat.generate.views.EventViews;
import arcomat.generate.views.Heads;
import arcomat.generate.views.NetworkViews;
import arcomat.model.Component;
import arcomat.model.Type;

import java.util.Optional;

/** Everything that files are made for, in a fixed order. */
final class Views {
    private final Program program;
    private final SelfWatches watches;
    private final Request request;
    private final OutputFiles output;
    private final TargetFindings findings;

    Views(
            Program program,
            SelfWatches watches,
            Request request,
            OutputFiles output,
            TargetFindings findings) {
        this.program = program;
        this.watches = watches;
        this.request = request;
        this.output = output;
        this.findings = findings;
    }

    void write() {
        program.contexts().forEach(this::component);
        watches.views().forEach(view -> output.write(Kind.MONITOR, view.head(), view));
        request.programs().forEach(this::program);
    }

    private void component(FileContext context) {
        Component component = context.component();
        HeadView head = Heads.of(component, program);
        Optional<AutomatonPlan> automaton = program.automaton(component);
        if (context.isEventDriven()) {
            eventDriven(context, head);
        } else if (component.platform()) {
            boolean senses = !component.outputs().isEmpty();
            boolean acts = !component.inputs().isEmpty();
            platform(component, Kind.PLATFORM, head, new PlatformView(head, senses, acts, ""));
        } else if (automaton.isPresent()) {
            AtomicViews views = new AtomicViews(context, automaton.get(), program.traced());
            output.write(Kind.ATOMIC, head, views.view(head));
        } else if (context.composition().isPresent()) {
            CompositeViews views = new CompositeViews(context, program, head);
            output.write(Kind.COMPOSITE, head, views.view());
            for (PartsView view : views.sections()) {
                output.write(Kind.SECTION, view.self(), view);
            }
        }
    }

    private void eventDriven(FileContext context, HeadView head) {
        Component component = context.component();
        Optional<AutomatonPlan> automaton = program.automaton(component);
        if (automaton.isPresent()) {
            EventViews views = new EventViews(context, program, head);
            output.write(Kind.EVENT, head, views.view(automaton.get()));
            return;
        }
        NetworkViews views = new NetworkViews(context, program, head);
        if (component.platform()) {
            platform(component, Kind.BORDER, head, views.view());
        } else {
            output.write(Kind.NETWORK, head, views.view());
            for (SubnetworkView view : views.sections()) {
                output.write(Kind.SUBNETWORK, view.self(), view);
            }
        }
    }

    /**
     * A class written by hand wins. Where there is none, some targets make platform components
     * themselves, and others cannot do without.
     */
    private void platform(Component component, Kind kind, HeadView head, Record view) {
        Optional<GeneratedFile> skeleton = output.draft(kind, head, view);
        if (skeleton.isEmpty()) {
            return;
        }
        String path = skeleton.get().path();
        String general = generalName(component);
        String generalPath = path.replace(head.self().name(), general);
        String byHand = request.handwritten().get(path);
        String forAll = request.handwritten().get(generalPath);
        if (byHand != null) {
            output.copy(path, byHand);
        } else if (view instanceof PlatformView platform
                && forAll != null
                && mayBeWrittenForAll(component)) {
            output.copy(generalPath, forAll);
            output.write(kind, head, platform.extending(general));
        } else if (needsClass()) {
            findings.implementation(component, skeleton.get());
        } else {
            output.write(kind, head, view);
        }
    }

    /**
     * Whether one class may serve every instantiation of a generic component. It can where all
     * messages are enums: they are numbers, whatever the enum.
     */
    private static boolean mayBeWrittenForAll(Component component) {
        return !generalName(component).equals(component.name())
                && component.ports().stream().allMatch(p -> p.type() instanceof Type.EnumType);
    }

    /** Without type arguments. */
    private static String generalName(Component component) {
        return component.name().replaceFirst("<.*", "");
    }

    private boolean needsClass() {
        return program.names().language().entry("platform").orElse("").strip().equals("class");
    }

    private void program(Component main) {
        TypeName name = program.nameOfProgram(main);
        boolean events = program.context(main).isEventDriven();
        ProgramView view =
                new ProgramView(
                        Heads.of(main, program),
                        name,
                        program.senses(main) && !(events && main.platform()),
                        events && !main.platform(),
                        events ? "" : program.call(main),
                        Integer.toString(main.cycle()),
                        watches.of(main));
        output.write(Kind.PROGRAM, name, view);
    }
}
