import lejos.nxt.LCD;

/** Draws with points and asks for them again. */
public class Points {
    public static void main(String[] args) {
        LCD.setPixel(3, 9, 1);
        LCD.setPixel(99, 63, 1);
        LCD.setPixel(100, 64, 1); // is nowhere
        LCD.drawString(LCD.getPixel(3, 9) + " " + (LCD.getDisplay()[103] & 0xff), 0, 4);
        byte[] square = {3, 3};
        LCD.bitBlt(square, 2, 2, 0, 0, 2, 8, 2, 2, LCD.ROP_XOR);
        LCD.drawString(row(8) + row(9), 0, 5);
        LCD.bitBlt(null, 2, 2, 0, 0, 2, 8, 3, 2, LCD.ROP_INVERT);
        LCD.drawString(row(8) + row(9), 0, 6);
        LCD.drawString("text", 0, 1); // lies upon the points
        LCD.drawString(row(8) + row(9) + LCD.getPixel(99, 63), 0, 7);
    }

    private static String row(int y) {
        return LCD.getPixel(1, y)
                + ""
                + LCD.getPixel(2, y)
                + LCD.getPixel(3, y)
                + LCD.getPixel(4, y)
                + " ";
    }
}
