package arcomat.agent;

import arcomat.agent.server.LineConnection;
import arcomat.agent.server.ToolServer;
import arcomat.agent.server.Workshop;

import java.io.InputStream;
import java.io.OutputStream;

/** Serves one agent, as the Model Context Protocol says. */
public final class AgentService {
    private AgentService() {}

    /**
     * Answers until the agent goes, and what it has asked before that.
     *
     * @param version of the tool
     */
    public static void serve(InputStream in, OutputStream out, AgentTerms terms, String version)
            throws InterruptedException {
        try (Workshop workshop = new Workshop(terms.session(), terms.roots(), terms.patience())) {
            ToolServer server = new ToolServer(workshop, terms.longest(), version);
            new LineConnection(in, out).serve(server);
        }
    }
}
