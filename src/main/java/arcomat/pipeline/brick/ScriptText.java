package arcomat.pipeline.brick;

import arcomat.sim.script.ParsedScript;
import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptError;
import arcomat.sim.script.ScriptParser;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A script that was read.
 *
 * @param script absent if there are findings
 */
public record ScriptText(Optional<Script> script, List<Diagnostic> findings) {
    private static final String BROKEN = "ARC0808";

    public static ScriptText read(SourceFile file) {
        ParsedScript parsed = ScriptParser.parse(file.text());
        List<Integer> starts = new ArrayList<>(List.of(0));
        for (String line : file.text().split("(?<=\\R)", -1)) {
            starts.add(starts.get(starts.size() - 1) + line.length());
        }
        return new ScriptText(
                parsed.script(),
                parsed.errors().stream().map(error -> finding(file, error, starts)).toList());
    }

    private static Diagnostic finding(SourceFile file, ScriptError error, List<Integer> starts) {
        int length = file.text().length();
        int start = Math.min(starts.get(error.line() - 1) + error.column() - 1, length);
        int end = Math.min(start + error.length(), length);
        return Diagnostic.error(BROKEN, file.span(start, end), error.message());
    }
}
