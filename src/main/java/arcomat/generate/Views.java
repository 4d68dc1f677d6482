package arcomat.generate;

import arcomat.generate.language.TemplateFailure;
import arcomat.generate.language.TypeName;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.PartsView;
import arcomat.generate.view.PlatformView;
import arcomat.generate.view.ProgramView;
import arcomat.model.Component;
import arcomat.model.Type;

import java.util.Optional;

/** Everything that files are made for, in a fixed order. */
final class Views {
    private final Program program;
    private final MessageTypes types;
    private final SelfWatches watches;
    private final Request request;
    private final TargetFindings findings;

    Views(
            Program program,
            MessageTypes types,
            SelfWatches watches,
            Request request,
            TargetFindings findings) {
        this.program = program;
        this.types = types;
        this.watches = watches;
        this.request = request;
        this.findings = findings;
    }

    void all(Output output) throws TemplateFailure {
        output.write(types);
        for (FileContext context : program.contexts()) {
            component(context, output);
        }
        watches.write(output);
        for (Component main : request.programs()) {
            program(main, output);
        }
    }

    private void component(FileContext context, Output output) throws TemplateFailure {
        Component component = context.component();
        HeadView head = Heads.of(context, program.draws(component));
        if (component.profile() == Component.Profile.EVENT_DRIVEN) {
            eventDriven(context, head, output);
        } else if (component.platform()) {
            PlatformView view =
                    new PlatformView(
                            head,
                            !component.outputs().isEmpty(),
                            !component.inputs().isEmpty(),
                            "");
            platform(context, "platform", head, view, output);
        } else if (context.composition().isPresent()) {
            CompositeViews views = new CompositeViews(context, program);
            output.write("composite", head, views.view(head));
            for (PartsView view : views.sections(head)) {
                output.write("section", view.folder(), view.prefix(), view.name(), view);
            }
        } else if (Members.automaton(component).isPresent()) {
            AtomicViews views = new AtomicViews(context, program.choosing());
            output.write("atomic", head, views.view(head, program.traced()));
        }
    }

    private void eventDriven(FileContext context, HeadView head, Output output)
            throws TemplateFailure {
        EventViews views = new EventViews(context, program);
        if (Members.automaton(context.component()).isPresent()) {
            output.write("event", head, views.atomic(head));
        } else {
            if (context.component().platform()) {
                platform(context, "border", head, views.network(head), output);
            } else {
                output.write("network", head, views.network(head));
            }
        }
    }

    /**
     * A class written by hand wins. Where there is none, some targets make platform components
     * themselves, and others cannot do without.
     */
    private void platform(
            FileContext context, String subject, HeadView head, Record view, Output output)
            throws TemplateFailure {
        Optional<GeneratedFile> skeleton = output.draft(subject, head, view);
        Optional<String> byHand = skeleton.map(GeneratedFile::path).map(request.handwritten()::get);
        if (byHand.isPresent()) {
            output.copy(skeleton.get().path(), byHand.get());
        } else if (view instanceof PlatformView platform
                && skeleton.isPresent()
                && isWrittenForAll(context.component(), skeleton.get(), head)) {
            String general = generalName(context.component());
            String path = generalPath(context.component(), skeleton.get(), head);
            output.copy(path, request.handwritten().get(path));
            output.write(subject, head, platform.extending(general));
        } else if (skeleton.isPresent() && needsClass()) {
            findings.implementation(context.component(), skeleton.get());
        } else {
            output.write(subject, head, view);
        }
    }

    /**
     * Whether one class serves every instantiation of a generic component. It can where all
     * messages are enums: they are numbers, whatever the enum.
     */
    private boolean isWrittenForAll(Component component, GeneratedFile skeleton, HeadView head) {
        return !generalName(component).equals(component.name())
                && component.ports().stream().allMatch(p -> p.type() instanceof Type.EnumType)
                && request.handwritten().containsKey(generalPath(component, skeleton, head));
    }

    private static String generalPath(Component component, GeneratedFile skeleton, HeadView head) {
        return skeleton.path().replace(head.name(), generalName(component));
    }

    /** Without type arguments. */
    private static String generalName(Component component) {
        return component.name().replaceFirst("<.*", "");
    }

    private boolean needsClass() {
        return program.names().language().entry("platform").orElse("").strip().equals("class");
    }

    private void program(Component main, Output output) throws TemplateFailure {
        TypeName name = program.nameOfProgram(main);
        HeadView head = Heads.of(program.context(main), program.draws(main));
        boolean events = main.profile() == Component.Profile.EVENT_DRIVEN;
        ProgramView view =
                new ProgramView(
                        head,
                        name.packageName(),
                        name.prefix(),
                        name.folder(),
                        name.name(),
                        program.senses(main) && !(events && main.platform()),
                        events && !main.platform(),
                        events ? "" : program.call(main),
                        Integer.toString(main.cycle()),
                        watches.of(main));
        output.write("program", name.folder(), name.prefix(), name.name(), view);
    }
}
