package arcomat.agent;

import arcomat.pipeline.Session;

import java.util.List;

/**
 * What an agent may do.
 *
 * @param session in which nothing outside of the model roots is read
 * @param roots the model roots, as the user wrote them
 * @param seconds that a call may take
 * @param longest characters of an answer; what is longer comes in parts
 */
public record AgentTerms(Session session, List<String> roots, int seconds, int longest) {
    public AgentTerms {
        roots = List.copyOf(roots);
    }
}
