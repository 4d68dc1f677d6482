package arcomat.agent;

import arcomat.pipeline.Session;

import java.time.Duration;
import java.util.List;

/**
 * What an agent may do.
 *
 * @param session in which nothing outside of the model roots is read
 * @param roots the model roots, as the user wrote them
 * @param patience time that a call may take
 * @param longest characters of an answer; what is longer comes in parts
 */
public record AgentTerms(Session session, List<String> roots, Duration patience, int longest) {
    public AgentTerms {
        roots = List.copyOf(roots);
    }
}
