package arcomat.pipeline.recheck;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.file.AtomicFile;

import java.util.List;

/**
 * Checks files and folders as {@link CheckFiles} does, but only what has changed since the last
 * time and what that touches. The result is the same.
 *
 * @param executable as there
 * @param state a file in which the check leaves for the next one what it needs to know
 * @param tool whatever tells this tool from others that may find something else
 */
public record CheckAgain(List<String> paths, boolean executable, String state, String tool)
        implements Task<Recheck> {
    /**
     * @throws WrongUse where the state cannot be written
     */
    @Override
    public Recheck run(Session session) throws WrongUse {
        IncrementalCheck.Outcome outcome =
                new IncrementalCheck(paths, CheckFiles.profile(executable), tool, session)
                        .run(new StateFile(state, session.names()));
        AtomicFile.write(state, StateFile.text(outcome.state()), session.names());
        return new Recheck(outcome.result(), outcome.checked());
    }
}
