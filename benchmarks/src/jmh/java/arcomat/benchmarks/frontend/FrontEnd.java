package arcomat.benchmarks.frontend;

import arcomat.check.Checks;
import arcomat.check.Profile;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Set;

/** The product's front end, as the pipeline calls it: large models by several threads. */
final class FrontEnd {
    private FrontEnd() {}

    static List<Unit> parse(List<SourceFile> files) {
        return files.parallelStream().map(file -> Parser.parse(file).unit().orElseThrow()).toList();
    }

    /** Parses, resolves and checks. */
    static List<Diagnostic> check(List<SourceFile> files) {
        return Checks.run(Workspace.of(parse(files), Set.of()), Profile.EXECUTABLE);
    }
}
