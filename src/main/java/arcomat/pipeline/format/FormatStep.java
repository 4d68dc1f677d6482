package arcomat.pipeline.format;

import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileFindings;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Formatter;
import arcomat.syntax.Formatter.Formatted;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Brings files into canonical form; files with errors are left as they are. */
public final class FormatStep {
    private FormatStep() {}

    /**
     * @param write false only lists what would change
     */
    public static FormatResult run(
            List<String> paths, boolean write, PathNames names, Progress progress) {
        FileFinder finder = new FileFinder(names);
        paths.forEach(finder::find);
        List<Diagnostic> findings = new ArrayList<>(finder.findings());
        List<String> changed = new ArrayList<>();
        progress.step("formatting", finder.files().size(), "file");
        for (FileFinder.Found found : finder.files()) {
            FileReader.Read read = FileReader.read(found.path(), found.shown());
            read.finding().ifPresent(findings::add);
            if (read.file().isPresent()) {
                format(found, read.file().get(), write, changed, findings);
            }
        }
        findings.sort(Diagnostic.ORDER);
        return new FormatResult(changed, findings, finder.files().size());
    }

    private static void format(
            FileFinder.Found found,
            SourceFile file,
            boolean write,
            List<String> changed,
            List<Diagnostic> findings) {
        Formatted formatted = Formatter.format(file);
        findings.addAll(formatted.findings());
        if (formatted.text().isEmpty() || formatted.text().get().equals(file.text())) {
            return;
        }
        try {
            if (write) {
                AtomicFile.write(found.path(), formatted.text().get());
            }
            changed.add(file.path());
        } catch (IOException e) {
            findings.add(
                    FileFindings.error(
                            FileFindings.UNREADABLE,
                            file.path(),
                            "'" + file.path() + "' cannot be written: " + Failures.reason(e)));
        }
    }
}
