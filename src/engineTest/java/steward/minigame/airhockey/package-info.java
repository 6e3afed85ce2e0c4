/**
 * Air hockey for two, made by the manual's page on adding a game and nothing else: the smallest whole game. Walls 0 and
 * 2 have a goal in their middle, wall 4 is the line that keeps the paddles apart and lets the puck pass.
 */
package steward.minigame.airhockey;
