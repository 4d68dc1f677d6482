package arcomat.pipeline.check;

import arcomat.symbols.Workspace;
import arcomat.symbols.names.DiagramSymbol;

import java.util.List;

/** What a command wants of models: what it does not want may have errors. */
@FunctionalInterface
public interface Asked {
    /** All that there is. */
    Asked EVERYTHING = whole -> false;

    /** As much as there is, file by file. */
    Asked WHAT_IS_WHOLE = whole -> true;

    /**
     * Whether it is there.
     *
     * @param whole files that need no other ones
     */
    boolean isIn(Workspace whole);

    /**
     * Components and class diagrams; everything where there are none.
     *
     * @param written as for {@link PromiseReference}
     */
    static Asked components(List<String> written) {
        return whole -> !written.isEmpty() && written.stream().allMatch(each -> isIn(each, whole));
    }

    private static boolean isIn(String written, Workspace whole) {
        String name = PromiseReference.parse(written).component();
        return !MainComponent.symbols(name, whole).isEmpty()
                || whole.diagrams().stream()
                        .map(DiagramSymbol::qualifiedName)
                        .anyMatch(name::equals);
    }
}
