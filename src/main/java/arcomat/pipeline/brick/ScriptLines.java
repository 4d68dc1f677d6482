package arcomat.pipeline.brick;

import arcomat.pipeline.beside.BesideText;
import arcomat.sim.script.ScriptWords;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.List;

/** A script, while somebody writes it: it refers to nothing, and has few words. */
public record ScriptLines(SourceFile text) implements BesideText {
    @Override
    public List<Diagnostic> findings() {
        return ScriptText.read(text).findings();
    }

    @Override
    public List<Link> links() {
        return List.of();
    }

    @Override
    public List<Choice> choices(int offset) {
        SourceFile before = BesideText.before(text, offset);
        return Choice.words(ScriptWords.after(before.line(before.lineCount())));
    }
}
