package arcomat.generate;

import arcomat.generate.language.TargetLanguage;
import arcomat.generate.language.TargetNames;
import arcomat.generate.monitor.SelfWatches;
import arcomat.generate.plan.AutomatonPlan;
import arcomat.generate.plan.Program;
import arcomat.generate.template.TemplateFailure;
import arcomat.generate.views.MessageTypes;
import arcomat.source.Diagnostic;

import java.util.List;

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
        return generate(
                target,
                (names, output, findings) -> {
                    Program program =
                            Program.of(
                                    names,
                                    request.choosing(),
                                    request.traced(),
                                    request.components());
                    SelfWatches watches = new SelfWatches(request.watches(), program);
                    MessageTypes types = new MessageTypes(program, watches.monitors());
                    output.write(types);
                    new Views(program, watches, request, output, findings).write();
                    findings.addAll(Sockets.check(request, target));
                    return CodeLayout.of(
                            program,
                            types,
                            request.programs(),
                            CodeLayout.automata(program, output));
                });
    }

    /** What writes files for a target, and tells where things are in them. */
    interface Writing {
        CodeLayout write(TargetNames names, OutputFiles output, TargetFindings findings);
    }

    /** What somebody writes, or findings that say why there is nothing. */
    static Generation generate(Target target, Writing writing) {
        TargetFindings findings = new TargetFindings(target);
        try {
            TargetNames names = new TargetNames(new TargetLanguage(target.entries()));
            OutputFiles output = new OutputFiles(target, findings);
            CodeLayout layout = writing.write(names, output, findings);
            boolean complete = findings.all().isEmpty();
            return new Generation(complete ? output.all() : List.of(), findings.all(), layout);
        } catch (TargetLanguage.MissingEntry e) {
            return Generation.failed(findings.missing(e));
        } catch (AutomatonPlan.TooManyChoices e) {
            return Generation.failed(
                    Diagnostic.error(
                            "ARC0805", e.component().span(), String.valueOf(e.getMessage())));
        } catch (AutomatonPlan.OnlyStatements e) {
            return Generation.failed(
                    Diagnostic.error(
                            "ARC0805", e.component().span(), String.valueOf(e.getMessage())));
        } catch (TemplateFailure e) {
            return Generation.failed(findings.template(e));
        }
    }
}
