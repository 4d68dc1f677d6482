package arcomat.pipeline.brick;

import arcomat.pipeline.beside.BesideText;
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

    /** It begins with a time, and what may follow depends on what is plugged in. */
    @Override
    public List<String> choices(int offset) {
        return List.of();
    }
}
