package arcomat.benchmarks.frontend;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Set;

/** The product's front end, as the pipeline calls it: large models by several threads. */
final class FrontEnd {
    /** For a program that answers once and waits for nobody: a fixed heap, and no short pauses. */
    static final String HEAP = "-Xms8g";

    static final String HEAP_LIMIT = "-Xmx8g";
    static final String PAUSES = "-XX:MaxGCPauseMillis=2000";
    static final String TENURING = "-XX:MaxTenuringThreshold=1";

    private FrontEnd() {}

    static List<Unit> parse(List<SourceFile> files) {
        return files.parallelStream().map(file -> Parser.parse(file).unit().orElseThrow()).toList();
    }

    /** Parses, resolves and checks. */
    static List<Diagnostic> check(List<SourceFile> files) {
        return Checks.run(
                Workspace.of(parse(files), Set.of(), HouseLanguages.reader()), Profile.EXECUTABLE);
    }
}
