package arcomat.pipeline.world;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.file.ReportPage;
import arcomat.report.world.WorldJson;
import arcomat.report.world.WorldPage;
import arcomat.world.Recording;

import java.io.IOException;

/**
 * Writes a page that plays a run of a world again and, beside it, the recording that it plays.
 *
 * @param title of the page
 * @param folder of the page, as the user wrote it
 */
public record WriteReplay(Recording recording, String title, String folder)
        implements Task<String> {
    private static final String RECORDING = "recording.json";

    /**
     * Returns the path of the page.
     *
     * @throws WrongUse where the folder is somebody else's, or cannot be written
     */
    @Override
    public String run(Session session) throws WrongUse {
        new ReportPage(folder, session.names()).write(WorldPage.render(recording, title));
        try {
            AtomicFile.write(
                    session.names().resolve(folder).resolve(RECORDING),
                    WorldJson.render(recording));
        } catch (IOException e) {
            throw Failures.cannot("write to", folder, e);
        }
        return folder + "/" + ReportPage.NAME;
    }
}
