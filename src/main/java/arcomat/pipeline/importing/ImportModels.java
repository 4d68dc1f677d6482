package arcomat.pipeline.importing;

import arcomat.check.guest.GuestThread;
import arcomat.guest.Importer.Original;
import arcomat.guest.Transcription;
import arcomat.guest.host.Guests.Kind;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.file.NewFolder;
import arcomat.source.Diagnostic;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeoutException;
import java.util.stream.Collectors;

/**
 * Has a guest read models of another language, and writes what it makes of them. What the guest
 * cannot read is a finding, and the rest is written.
 *
 * @param kind of models, a word of a guest
 * @param folder of the originals, as the user wrote it
 * @param out the folder to write, as the user wrote it
 * @param overwrite whether files may be replaced that are there
 */
public record ImportModels(String kind, String folder, String out, boolean overwrite)
        implements Task<ImportModels.Result> {
    /** Ten thousand files are read in less. */
    private static final Duration LIMIT = Duration.ofMinutes(2);

    /**
     * What came of it.
     *
     * @param originals what was found in them
     * @param written the number of files
     */
    public record Result(CheckResult originals, int written) {}

    /**
     * @throws WrongUse where nobody knows the kind, or where files are in the way
     */
    @Override
    public Result run(Session session) throws WrongUse {
        Kind known = known(session.guests().kinds());
        requireFolders(session.names());
        List<Diagnostic> findings = new ArrayList<>();
        List<Original> originals = originals(known, session, findings);
        ImportedFiles imported = ImportedFiles.NONE;
        if (!originals.isEmpty()) {
            imported = converted(known, originals);
            findings.addAll(imported.findings());
            write(imported.texts(), session.names());
        }
        findings.sort(Diagnostic.ORDER);
        List<String> paths = originals.stream().map(each -> each.file().path()).toList();
        return new Result(new CheckResult(findings, List.of(), paths), imported.texts().size());
    }

    private Kind known(List<Kind> kinds) throws WrongUse {
        if (kinds.isEmpty()) {
            throw new WrongUse(
                    "nobody here imports models of kind '%s'; --with names a guest that does",
                    kind);
        }
        return kinds.stream()
                .filter(each -> each.word().equals(kind))
                .findFirst()
                .orElseThrow(
                        () ->
                                new WrongUse(
                                        "nobody here imports models of kind '%s'; there is %s",
                                        kind,
                                        kinds.stream()
                                                .map(each -> "'" + each.word() + "'")
                                                .collect(Collectors.joining(", "))));
    }

    private void requireFolders(PathNames names) throws WrongUse {
        Path from = PathNames.real(names.readable(folder));
        if (!Files.isDirectory(from)) {
            throw new WrongUse("there is no folder '%s' to import", folder);
        }
        Path to = names.resolve(out).toAbsolutePath().normalize();
        if (PathNames.real(to).startsWith(from)) {
            throw new WrongUse(
                    "'%s' lies in the folder that is imported; the next import would read it", out);
        }
        if (!overwrite) {
            NewFolder.requireFree(to, out);
        }
    }

    private List<Original> originals(Kind known, Session session, List<Diagnostic> findings) {
        FileFinder finder = new FileFinder(session.names(), known.endings(), "file");
        finder.find(folder);
        findings.addAll(finder.findings());
        Path from = session.names().resolve(folder).normalize();
        List<Original> originals = new ArrayList<>();
        session.progress().step("reading", finder.files().size(), "file");
        for (FileFinder.Found found : finder.files()) {
            FileReader.Read read = FileReader.read(found.path(), found.shown());
            read.finding().ifPresent(findings::add);
            String path = from.relativize(found.path().normalize()).toString().replace('\\', '/');
            read.file().ifPresent(file -> originals.add(new Original(path, file)));
        }
        originals.sort(Comparator.comparing(Original::path));
        return originals;
    }

    private static ImportedFiles converted(Kind known, List<Original> originals) {
        Transcription transcription = new Transcription();
        try {
            new GuestThread(known.guest(), LIMIT)
                    .call(
                            Executors.callable(
                                    () -> known.importer().read(originals, transcription)));
            return ImportedFiles.of(known, transcription);
        } catch (ExecutionException e) {
            return ImportedFiles.failed(
                    known, originals.get(0).file(), String.valueOf(e.getCause()));
        } catch (TimeoutException e) {
            String reason = "not done after " + LIMIT.toSeconds() + " s";
            return ImportedFiles.failed(known, originals.get(0).file(), reason);
        }
    }

    /** A new folder appears as a whole; of one that is there, each file that is replaced. */
    private void write(Map<String, String> texts, PathNames names) throws WrongUse {
        if (texts.isEmpty()) {
            return;
        }
        if (!overwrite) {
            NewFolder.create(out, texts, names);
            return;
        }
        for (Map.Entry<String, String> text : texts.entrySet()) {
            AtomicFile.write(out + "/" + text.getKey(), text.getValue(), names);
        }
    }
}
