package arcomat.pipeline.diagram;

import arcomat.model.Automaton;
import arcomat.pipeline.Session;
import arcomat.pipeline.check.LoweredModels;
import arcomat.source.Diagnostic;

import java.util.List;

/** A source of findings about automata, which pictures mark at states and transitions. */
public interface MarkedFindings {
    /** Marks nothing. */
    MarkedFindings NONE = (models, session) -> List.of();

    /**
     * Findings about one automaton.
     *
     * @param findings each at a state or a transition of the automaton
     */
    record Marked(Automaton automaton, List<Diagnostic> findings) {
        public Marked {
            findings = List.copyOf(findings);
        }
    }

    /** Findings about the automata of all models that were named. */
    List<Marked> find(LoweredModels models, Session session);
}
