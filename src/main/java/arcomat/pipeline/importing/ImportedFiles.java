package arcomat.pipeline.importing;

import arcomat.guest.Transcription;
import arcomat.guest.Transcription.Finding;
import arcomat.guest.Transcription.Written;
import arcomat.guest.host.Guests.Kind;
import arcomat.pipeline.file.FileFinder;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Formatter;
import arcomat.syntax.Formatter.Formatted;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a guest made of models in another language, judged: what cannot be read again is not
 * written.
 *
 * @param texts in canonical form, by their paths in the folder to write
 */
record ImportedFiles(Map<String, String> texts, List<Diagnostic> findings) {
    static final ImportedFiles NONE = new ImportedFiles(Map.of(), List.of());

    /** ARC1205: a guest fails while it imports. */
    private static final String FAILED = "ARC1205";

    /** Nothing came of it. */
    static ImportedFiles failed(Kind kind, SourceFile first, String reason) {
        String message =
                "guest '%s' failed while it read models of kind '%s', and nothing is written: %s; tell who wrote it"
                        .formatted(kind.guest(), kind.word(), reason);
        return new ImportedFiles(
                Map.of(), List.of(Diagnostic.error(FAILED, first.span(0, 0), message)));
    }

    static ImportedFiles of(Kind kind, Transcription transcription) {
        Map<String, String> texts = new LinkedHashMap<>();
        List<Diagnostic> findings = new ArrayList<>();
        for (Finding each : transcription.findings()) {
            findings.add(finding(kind, each));
        }
        for (Written file : transcription.files()) {
            Optional<String> fault = fault(file, texts);
            if (fault.isPresent()) {
                findings.add(wrong(kind, file, fault.get()));
                continue;
            }
            Formatted formatted = Formatter.format(new SourceFile(file.path(), file.text()));
            if (formatted.text().isPresent()) {
                texts.put(file.path(), formatted.text().get());
            } else if (isCopied(file)) {
                findings.addAll(Formatter.format(file.original()).findings());
            } else {
                findings.add(wrong(kind, file, unreadable(formatted.findings().get(0))));
            }
        }
        return new ImportedFiles(texts, findings);
    }

    /** What is wrong with a copy is wrong with the original, and no guest's fault. */
    private static boolean isCopied(Written file) {
        return file.text().equals(file.original().text());
    }

    private static String unreadable(Diagnostic first) {
        String line = first.span().file().excerpt(first.span().startPosition().line());
        return "cannot be read: %s in '%s'".formatted(first.message(), line);
    }

    private static Diagnostic finding(Kind kind, Finding finding) {
        String message = finding.message() + " (guest '" + kind.guest() + "')";
        if (!kind.codes().contains(finding.code())) {
            return Diagnostic.error(
                    FAILED,
                    finding.place(),
                    "guest '%s' has not said that it has a code '%s'; tell who wrote it: %s"
                            .formatted(kind.guest(), finding.code(), finding.message()));
        }
        return finding.hard()
                ? Diagnostic.error(finding.code(), finding.place(), message)
                : Diagnostic.warning(finding.code(), finding.place(), message);
    }

    /** Why a file cannot stand beside the others. */
    private static Optional<String> fault(Written file, Map<String, String> others) {
        Path path = Path.of("root", file.path()).normalize();
        if (Path.of(file.path()).isAbsolute()
                || !path.startsWith("root")
                || path.getNameCount() < 2) {
            return Optional.of("would lie outside of the folder");
        }
        if (!FileFinder.isModelFile(path)) {
            return Optional.of("is no file of models by its name");
        }
        return others.containsKey(file.path()) ? Optional.of("is written twice") : Optional.empty();
    }

    private static Diagnostic wrong(Kind kind, Written file, String reason) {
        return Diagnostic.error(
                FAILED,
                file.original().span(0, 0),
                "guest '%s' made '%s' of this file, which %s; it is not written; tell who wrote the guest"
                        .formatted(kind.guest(), file.path(), reason));
    }
}
