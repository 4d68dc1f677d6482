package arcomat.pipeline.file;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.guest.GuestLayout;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Formatter.Formatted;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Brings files into canonical form; files with errors are left as they are.
 *
 * @param write false only lists what would change
 */
public record FormatFiles(List<String> paths, boolean write) implements Task<FormatFiles.Result> {
    /**
     * What formatting a set of files did.
     *
     * @param changed paths of the files whose text was, or would be, changed
     * @param findings why other files were left alone
     * @param files the number of files looked at
     */
    public record Result(List<String> changed, List<Diagnostic> findings, int files) {
        public boolean hasUnreadableInput() {
            return findings.stream().anyMatch(FileFindings::isUnreadableInput);
        }
    }

    @Override
    public Result run(Session session) {
        FileFinder finder = new FileFinder(session.names());
        paths.forEach(finder::find);
        List<Diagnostic> findings = new ArrayList<>(finder.findings());
        List<String> changed = new ArrayList<>();
        GuestLayout layout = new GuestLayout(session.guests());
        session.progress().step("formatting", finder.files().size(), "file");
        for (FileFinder.Found found : finder.files()) {
            FileReader.Read read = FileReader.read(found.path(), found.shown());
            read.finding().ifPresent(findings::add);
            if (read.file().isPresent()) {
                Formatted formatted = layout.format(read.file().get());
                findings.addAll(formatted.findings());
                write(found, read.file().get(), formatted, changed, findings);
            }
        }
        findings.sort(Diagnostic.ORDER);
        return new Result(changed, findings, finder.files().size());
    }

    private void write(
            FileFinder.Found found,
            SourceFile file,
            Formatted formatted,
            List<String> changed,
            List<Diagnostic> findings) {
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
