package arcomat.pipeline.world;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.report.world.WorldAnimation;
import arcomat.world.Recording;

import java.io.IOException;

/**
 * Writes a run of a world as a picture that moves.
 *
 * @param title of the picture
 * @param file as the user wrote it
 */
public record WriteAnimation(Recording recording, String title, String file)
        implements Task<String> {
    /**
     * Returns the path of the picture.
     *
     * @throws WrongUse where it cannot be written
     */
    @Override
    public String run(Session session) throws WrongUse {
        try {
            AtomicFile.write(
                    session.names().resolve(file), WorldAnimation.render(recording, title));
        } catch (IOException e) {
            throw Failures.cannot("write", file, e);
        }
        return file;
    }
}
