package arcomat.pipeline.check;

import static java.util.stream.Collectors.toSet;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.report.finding.Baseline;
import arcomat.report.finding.Baseline.Entry;
import arcomat.report.finding.BaselineText;
import arcomat.source.Diagnostic;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A file of known findings. Its paths count from the folder that it lies in: it fits wherever the
 * models are checked out and from wherever the tool is started.
 *
 * @param file as the user wrote it
 */
public record BaselineFile(String file, PathNames names) {

    /** Entries of files that nobody looked at are not gone, as long as the files are there. */
    public Baseline.Comparison compare(CheckResult check) throws WrongUse {
        Baseline.Comparison all = read().compare(check.findings(), this::path);
        Set<String> checked = check.paths().stream().map(this::path).collect(toSet());
        SortedMap<Entry, Integer> gone = new TreeMap<>();
        all.gone()
                .forEach(
                        (entry, times) -> {
                            Path place = folder().resolve(entry.path());
                            if (checked.contains(entry.path()) || !Files.exists(place)) {
                                gone.put(entry.at(shown(entry.path())), times);
                            }
                        });
        return new Baseline.Comparison(all.fresh(), all.known(), gone);
    }

    private String shown(String path) {
        return names.shown(folder().resolve(path), Path.of(path).isAbsolute());
    }

    /**
     * Lets the file know all of these findings.
     *
     * @throws WrongUse where it cannot be written
     */
    public void write(List<Diagnostic> findings) throws WrongUse {
        AtomicFile.write(file, BaselineText.render(Baseline.of(findings, this::path)), names);
    }

    private Baseline read() throws WrongUse {
        Path place = names.resolve(file);
        if (!Files.exists(place)) {
            throw new WrongUse(
                    "there is no baseline '%s'; --write-baseline %s makes one", file, file);
        }
        try {
            return BaselineText.parse(Files.readString(place));
        } catch (BaselineText.Damaged problem) {
            throw damaged(String.valueOf(problem.getMessage()));
        } catch (CharacterCodingException e) {
            throw damaged("it is not UTF-8");
        } catch (IOException e) {
            throw Failures.cannot("read", file, e);
        }
    }

    private WrongUse damaged(String reason) {
        return new WrongUse(
                "'%s' is no baseline: %s; restore it, or write it anew with --write-baseline %s",
                file, reason, file);
    }

    private Path folder() {
        return Objects.requireNonNull(names.resolve(file).toAbsolutePath().normalize().getParent());
    }

    private String path(String shown) {
        Path folder = folder();
        Path path = names.resolve(shown).toAbsolutePath().normalize();
        boolean related = path.getRoot().equals(folder.getRoot());
        return (related ? folder.relativize(path) : path).toString().replace('\\', '/');
    }
}
