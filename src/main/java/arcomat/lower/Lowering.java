package arcomat.lower;

import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.Resolution;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Turns what was written into what was meant. */
public final class Lowering {
    private final Workspace workspace;
    private final ComponentLowering components;

    private Lowering(Workspace workspace, Runnable goOn) {
        this.workspace = workspace;
        this.components = new ComponentLowering(workspace.delays(), goOn);
    }

    /**
     * The model of a set of files.
     *
     * @throws IllegalStateException where the files have error findings, which the caller rules out
     */
    public static Model lower(Workspace workspace) {
        return lower(workspace, () -> {});
    }

    /**
     * As above.
     *
     * @param goOn asked before each component; it may throw what ends the work
     */
    public static Model lower(Workspace workspace, Runnable goOn) {
        return new Lowering(workspace, goOn).model();
    }

    /** What the checks guarantee to be found. */
    static <T> T resolved(Resolution<T> resolution, Object what) {
        return resolution
                .found()
                .orElseThrow(() -> new IllegalStateException("unresolved: " + what));
    }

    private Model model() {
        for (ComponentSymbol component : workspace.meantComponents()) {
            if (!isGenericInside(component)) {
                components.lower(Instantiation.plain(component));
            }
        }
        List<Component> all = new ArrayList<>(components.lowered());
        for (AutomatonSymbol automaton : workspace.bareAutomata()) {
            all.add(components.bare(automaton));
        }
        all.sort(Comparator.comparing(Component::qualifiedName));
        return new Model(all, tests());
    }

    /** Whether it, or a component around it, needs type arguments. */
    private static boolean isGenericInside(ComponentSymbol component) {
        return component.signature().isGeneric()
                || component.enclosing().map(Lowering::isGenericInside).orElse(false);
    }

    private List<StreamTest> tests() {
        return workspace.testSuites().stream()
                .map(suite -> new StreamTestLowering(components, workspace.delays(), suite))
                .flatMap(lowering -> lowering.lower().stream())
                .toList();
    }
}
