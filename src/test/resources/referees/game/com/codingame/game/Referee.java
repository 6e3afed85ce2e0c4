package com.codingame.game;

import com.codingame.gameengine.core.AbstractPlayer.TimeoutException;
import com.codingame.gameengine.core.AbstractReferee;
import com.codingame.gameengine.core.MultiplayerGameManager;
import com.google.inject.Inject;

/**
 * A small game on the SDK: guess a number; two to three players, leagues, a static that remembers. Seeds from 101 are
 * faults of the referee.
 */
public class Referee extends AbstractReferee {

    private static final int HUGE = 17 << 20;
    private static int remembered;

    @Inject
    private MultiplayerGameManager<Player> gameManager;

    @Override
    public void init() {
        gameManager.setMaxTurns(5);
        gameManager.setTurnMaxTime(50);
        remembered++;
        System.out.println("noise of the referee");
        if (gameManager.getSeed() == 104) {
            gameManager.endGame();
        } else if (gameManager.getSeed() == 105) {
            gameManager.setMaxTurns(100_000);
        }
    }

    @Override
    public void gameTurn(int turn) {
        if (gameManager.getSeed() == 105) {
            return;
        }
        if (turn == 2) {
            fail((int) gameManager.getSeed());
        }
        int number = gameManager.getRandom().nextInt(Integer.getInteger("league.level") * 100);
        for (Player player : gameManager.getActivePlayers()) {
            player.sendInputLine(turn + " " + number);
            player.execute();
        }
        for (Player player : gameManager.getActivePlayers()) {
            try {
                player.setScore(player.getScore() + (player.getOutputs().get(0).equals("" + number) ? 1 : 0));
            } catch (TimeoutException late) {
                player.deactivate("late");
                player.setScore(-1);
            }
        }
        gameManager.addToGameSummary("turn " + turn + ", remembered " + remembered);
    }

    private void fail(int seed) {
        switch (seed) {
            case 101 -> System.exit(7);
            case 102 -> throw new IllegalStateException("no such cell");
            case 103 -> {
                while (true) {
                    Thread.onSpinWait();
                }
            }
            case 106 -> {
                while (true) {
                    System.out.println("flood");
                }
            }
            case 107 -> gameManager.getPlayer(0).sendInputLine("x".repeat(HUGE));
            default -> { }
        }
    }
}
