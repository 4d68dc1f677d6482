package arcomat.pipeline.analysis;

import arcomat.model.Automaton.Completion;

import java.util.Optional;

/**
 * Whether one component keeps the promises of another.
 *
 * @param left as written: a component, or {@code component#automaton}
 * @param leftCompletion in place of that of its automata
 * @param mona name or path of the program MONA, where it is to be asked instead of the engine
 * @param certificate file to write the proof to, where there is one
 * @param doubted file with a proof that is to be verified; nothing is searched then
 * @param diagram file for a picture of how it fails, where it does
 */
public record RefinesRequest(
        String left,
        String right,
        Optional<Completion> leftCompletion,
        Optional<Completion> rightCompletion,
        Optional<String> mona,
        Optional<String> certificate,
        Optional<String> doubted,
        Optional<String> diagram,
        AnalysisLimits limits) {}
