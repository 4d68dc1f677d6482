package arcomat.generate;

import arcomat.generate.view.ClassView;
import arcomat.model.Component;
import arcomat.semantics.network.Composition;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Tells those who drive generated code where things are. */
final class Layouts {
    private Layouts() {}

    static Layout of(Program program, MessageTypes types, List<Component> mains) {
        Map<String, Layout.Place> places = new LinkedHashMap<>();
        for (FileContext context : program.contexts()) {
            places.put(context.component().qualifiedName(), place(context, program));
        }
        Map<String, Layout.MessageClass> classes = new LinkedHashMap<>();
        for (ClassView view : types.classes()) {
            String qualified =
                    (view.packageName().isEmpty() ? "" : view.packageName() + ".") + view.name();
            List<String> attributes =
                    view.attributes().stream().map(ClassView.AttributeView::name).toList();
            classes.put(view.model(), new Layout.MessageClass(qualified, attributes));
        }
        Map<String, String> programs = new LinkedHashMap<>();
        for (Component main : mains) {
            programs.put(main.qualifiedName(), program.nameOfProgram(main).qualified());
        }
        return new Layout(places, classes, programs);
    }

    private static Layout.Place place(FileContext context, Program program) {
        Component component = context.component();
        Members members = context.members();
        boolean automaton = Members.automaton(component).isPresent();
        return new Layout.Place(
                context.self().qualified(),
                program.draws(component),
                program.senses(component),
                Map.copyOf(members.ports()),
                Map.copyOf(members.flags()),
                Map.copyOf(members.methods()),
                Map.copyOf(members.variables()),
                automaton ? members.state() : "",
                automaton ? members.taken() : "",
                members.local("queued", ""),
                members.local("border", ""),
                parts(context, program),
                component.span());
    }

    private static Map<String, String> parts(FileContext context, Program program) {
        Map<String, String> parts = new LinkedHashMap<>();
        if (context.composition().isPresent()) {
            Arrangement arrangement = program.arrangement(context);
            int position = 0;
            for (Composition.Node node : arrangement.composition().nodes()) {
                parts.put(node.path(), arrangement.path(position++));
            }
        }
        return parts;
    }
}
