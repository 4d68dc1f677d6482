package arcomat.generate;

import arcomat.generate.language.Language;
import arcomat.generate.language.Names;
import arcomat.generate.language.TemplateFailure;
import arcomat.source.Diagnostic;

import java.util.List;
import java.util.Map;

/**
 * Writes a model in the language of a target. Pure: nothing is written to disk, and the same
 * request gives the same files, byte for byte.
 */
public final class Generator {
    private Generator() {}

    /**
     * Generates components with all that they are made of.
     *
     * @return files, or findings that say why there are none: {@code ARC0801} platform component
     *     without an implementation, {@code ARC0802} template that cannot be filled in, {@code
     *     ARC0803} description of the target that lacks something, {@code ARC0804} file that would
     *     leave the output folder or be written twice, {@code ARC0805} more alternatives in one
     *     state than random choices are generated for, {@code ARC0806} two devices in one socket
     */
    public static Generation generate(Request request, Target target) {
        TargetFindings findings = new TargetFindings(target);
        try {
            Map<String, String> entries = target.entries();
            Program program =
                    new Program(
                            new Names(new Language(entries)),
                            request.choosing(),
                            request.traced(),
                            request.components());
            Output output = new Output(target, findings);
            SelfWatches watches = new SelfWatches(request.watches(), program);
            MessageTypes types = new MessageTypes(program);
            types.add(watches.monitors());
            new Views(program, types, watches, request, findings).all(output);
            findings.addAll(Sockets.check(request, entries));
            return new Generation(
                    findings.all().isEmpty() ? output.files() : List.of(),
                    findings.all(),
                    Layouts.of(program, types, request.programs()));
        } catch (Language.MissingEntry e) {
            return Generation.failed(findings.missing(e.getMessage()));
        } catch (TooManyChoices e) {
            return Generation.failed(
                    Diagnostic.error("ARC0805", e.component().span(), e.getMessage()));
        } catch (TemplateFailure e) {
            return Generation.failed(findings.template(e));
        }
    }
}
