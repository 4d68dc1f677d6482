package arcomat.generate;

import arcomat.source.Diagnostic;

import java.util.List;

/**
 * What a generator gives: files, or findings that say why there are none.
 *
 * @param layout where the parts of the model are found in the generated code
 */
public record Generation(List<GeneratedFile> files, List<Diagnostic> findings, CodeLayout layout) {
    public Generation {
        files = List.copyOf(files);
        findings = List.copyOf(findings);
    }

    static Generation failed(Diagnostic finding) {
        return new Generation(List.of(), List.of(finding), CodeLayout.NONE);
    }
}
