package arcomat.benchmarks.compositions;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** The question of a system, asked in a process of its own: {@code philosophers 7}. */
public final class AskedComposition {
    private static final long MOST_STATES = 500_000_000;

    private AskedComposition() {}

    /** Prints the answer, and how many configurations of the system there are. */
    public static void main(String[] arguments) {
        ComposedSystem system = ComposedSystems.of(arguments[0], Integer.parseInt(arguments[1]));
        Component whole = model(system).component("load.Whole").orElseThrow();
        Verdict verdict =
                InvariantProof.check(
                        whole,
                        List.of(),
                        whole.invariants().get(0),
                        new Budget(() -> false, MOST_STATES));
        System.out.printf("%s %d%n", verdict.answer(), verdict.explored().pairs());
    }

    private static Model model(ComposedSystem system) {
        List<SourceFile> sources = new ArrayList<>();
        for (String text : ArcWriter.texts(system)) {
            sources.add(new SourceFile("load/" + sources.size() + ".arc", text));
        }
        return Lowering.lower(
                Workspace.of(
                        sources.stream()
                                .map(file -> Parser.parse(file).unit().orElseThrow())
                                .toList(),
                        Set.of(),
                        HouseLanguages.reader()));
    }
}
