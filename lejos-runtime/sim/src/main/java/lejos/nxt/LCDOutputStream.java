package lejos.nxt;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Screen;

import java.io.OutputStream;

/** Prints on the screen line by line, as System.out does on the brick. */
public class LCDOutputStream extends OutputStream {
    private static final Hardware BRICK = Hardware.of(LCDOutputStream.class);

    private int column;
    private int row;

    /** A full screen moves up. */
    @Override
    public void write(int c) {
        char character = (char) (c & 0xff);
        if (character == '\n') {
            column = 0;
            row++;
            return;
        }
        if (character < ' ') {
            return;
        }
        if (column == Screen.COLUMNS) {
            column = 0;
            row++;
        }
        if (row == Screen.ROWS) {
            BRICK.screen().scroll();
            row--;
        }
        BRICK.screen()
                .draw(character, column++, row); // must not wait: the PC locks its print streams
    }
}
